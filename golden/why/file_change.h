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
FileTexts toldTexts(const CellBundle& bundle);
/// True for the name of a file whose text toldTexts() keeps.
bool isToldText(const std::string& name);

/// "textures/floor.png: the texture has changed", one per file, sorted by name.
std::vector<std::string> fileChanges(const FileHashes& golden, const FileHashes& frame);

}  // namespace rocinante
