#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/cell/cell.h"

namespace rocinante {

/// True for a file that begins as a log does, or is named *.mcap.
bool isLog(const std::filesystem::path& path);

/// Loads a cell from whatever a program is given as one: a file as loadCell() takes it, or a log
/// with a cell in it. Faults of the latter name files as LOG:cell/NAME. `search` roots mean nothing
/// to a cell in a log, and are refused with it.
Result<Cell> loadCellOrLog(const std::filesystem::path& path, const CellOptions& options);

}  // namespace rocinante
