#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/cell/cell.h"

namespace rocinante {

/// True for a file that begins as a log does, or is named *.mcap.
bool isLog(const std::filesystem::path& path);

/// Loads a cell from a program's argument: a file that loadCell() takes, or a log that carries a
/// cell. Faults of the latter name files as LOG:cell/NAME. `search` roots are refused with a cell
/// in a log.
Result<Cell> loadCellOrLog(const std::filesystem::path& path, const CellOptions& options);

}  // namespace rocinante
