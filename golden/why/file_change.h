#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/model/cell.h"
#include "core/result.h"
#include "golden/manifest.h"

namespace rocinante {

/// Of whatever a program is given as a cell: a file with all that it names, or what a log carries.
Result<FileHashes> hashCellFiles(const std::filesystem::path& cell, const CellOptions& options);

/// "textures/floor.png: the texture has changed", one a file, by name.
std::vector<std::string> fileChanges(const FileHashes& golden, const FileHashes& frame);

}  // namespace rocinante
