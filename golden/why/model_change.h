#pragma once

#include <string>
#include <vector>

#include "core/bundle/cell_bundle.h"
#include "core/cell/cell.h"
#include "golden/approval/manifest.h"

namespace rocinante {

/// The drift.* findings of two cells, such as "joint elbow_joint of ur10 has moved by 20 mm", one
/// sentence each, after the faults of `now` (cellFaults).
std::vector<std::string> modelChanges(const Cell& golden, const Cell& now);

/// The same when only hashes of the golden's files and some of their texts are known, followed by
/// the changed files (fileChanges): the golden's cell is rebuilt from those texts and `today`'s
/// other files. `today` is `now` with its files; it is modified and restored. A line reports
/// missing texts.
std::vector<std::string> modelChanges(const FileHashes& golden, const FileTexts& texts,
                                      CellBundle& today, const Cell& now);

/// A cell's errors as printed by `check`: "arm.urdf:7: there is no file arm.stl".
std::vector<std::string> cellFaults(const Cell& cell);

}  // namespace rocinante
