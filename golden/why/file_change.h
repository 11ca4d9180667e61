#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/bundle/cell_bundle.h"
#include "golden/approval/manifest.h"

namespace rocinante {

/// The hashes of a cell's files.
FileHashes hashesOf(const CellBundle& bundle);
/// The contents of its kinematics and material files, of valid UTF-8 and at most 1 MiB each, for a
/// manifest.
FileTexts recordedTexts(const CellBundle& bundle);
/// True for the name of a file whose text recordedTexts() keeps.
bool isRecordedText(const std::string& name);

struct FileChange {
  std::string text;          ///< "textures/floor.png: the texture has changed"
  bool is_recorded = false;  ///< isRecordedText(): what changed in it is known where its text is
};
/// One per file, sorted by name. `texts` by hash; a text that differs only in comments and white
/// space has not changed, nor has a file that only has another name. A file that a text of both
/// cells names is missing, or was, where only one has it.
std::vector<FileChange> fileChanges(const FileHashes& golden, const FileHashes& frame,
                                    const FileTexts& texts = {});

}  // namespace rocinante
