#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/model/cell.h"
#include "core/result.h"

namespace rocinante {

/// Files that a cell is made of: name below the cell's folder to SHA-256.
using FileHashes = std::map<std::string, std::string>;

/// Of whatever a program is given as a cell: a file with all that it names, or what a log carries.
Result<FileHashes> hashCellFiles(const std::filesystem::path& cell, const CellOptions& options);

/// "textures/floor.png: the texture has changed", one a file, by name.
std::vector<std::string> fileChanges(const FileHashes& golden, const FileHashes& frame);

}  // namespace rocinante
