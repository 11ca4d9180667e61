#pragma once

#include <string>
#include <vector>

#include "core/bundle/cell_bundle.h"
#include "core/cell/cell.h"
#include "golden/approval/manifest.h"

namespace rocinante {

/// What `check` says of two cells (drift.*): "joint elbow_joint of ur10 has moved by 20 mm", a
/// sentence each; before them what `now` lacks (cellFaults).
std::vector<std::string> modelChanges(const Cell& golden, const Cell& now);

/// The same, where of the golden's cell only the hashes of its files and some of their texts are
/// left, and behind it the files that changed (fileChanges): the golden's cell is put together from
/// those texts and `today`'s other files. `today` is `now` with its files; it is changed and
/// changed back. Says so where a text is not there.
std::vector<std::string> modelChanges(const FileHashes& golden, const FileTexts& texts,
                                      CellBundle& today, const Cell& now);

/// A cell's errors, in the words of `check`: "arm.urdf:7: there is no file arm.stl".
std::vector<std::string> cellFaults(const Cell& cell);

}  // namespace rocinante
