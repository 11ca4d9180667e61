#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/bundle/cell_bundle.h"
#include "core/cell/cell.h"
#include "golden/approval/manifest.h"
#include "golden/why/golden_texts.h"

namespace rocinante {

/// A change of the model, as a sentence.
struct ModelChange {
  enum class Seen : std::uint8_t {
    drawn,   ///< pictures can show it
    camera,  ///< pictures of the camera `subject` can show it
    maybe,   ///< a file changed in something that is not compared
    never    ///< limits, collision shapes, layers
  };
  std::string text;
  std::string subject{};  ///< the device, model or camera; empty: a file
  Seen seen = Seen::drawn;
};
using ModelChanges = std::vector<ModelChange>;

/// The drift.* findings of two cells, such as "joint elbow_joint of ur10 has moved by 20 mm", one
/// sentence each, after the faults of `now` (cellFaults). What pictures never show comes last.
ModelChanges modelChanges(const Cell& golden, const Cell& now);

/// The same when only hashes of the golden's files and some of their texts are known, followed by
/// the changed files (fileChanges): the golden's cell is rebuilt from those texts, from the files
/// `at_hand` and `today`'s others. `today` is `now` with its files; it is modified and restored. A
/// line reports missing texts.
ModelChanges modelChanges(const FileHashes& golden, const FileTexts& texts, CellBundle& today,
                          const Cell& now, const FileContents& at_hand = {});
/// fileChanges() as changes; `texts` as there.
ModelChanges changedFiles(const FileHashes& golden, const FileHashes& frame,
                          const FileTexts& texts);

/// A cell's errors as printed by `check`: "arm.urdf:7: there is no file arm.stl".
ModelChanges cellFaults(const Cell& cell);

std::vector<std::string> textsOf(const ModelChanges& changes);

}  // namespace rocinante
