#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/bundle/cell_bundle.h"
#include "core/log/log_reader.h"
#include "core/model/cell.h"
#include "core/result.h"

namespace rocinante {

/// True for a file that begins as a log does, or is named *.mcap.
bool isLog(const std::filesystem::path& path);

/// The cell that a log carries, read whole and checked: every size, checksum and SHA-256. Empty
/// when the log has none; damaged when it should have one, naming the attachment. Of several the
/// first counts.
Result<std::optional<CellBundle>> readAttachedCell(const LogReader& log);

/// The bundle of whatever a program is given as a cell: collectCell(), or what a log carries.
Result<CellBundle> collectCellOrLog(const std::filesystem::path& path, const CellOptions& options);

/// Loads a cell from whatever a program is given as one: a file as loadCell() takes it, or a log
/// with a cell in it. Faults of the latter name files as LOG:cell/NAME. `search` roots mean nothing
/// to a cell in a log, and are refused with it.
Result<Cell> loadCellOrLog(const std::filesystem::path& path, const CellOptions& options);

}  // namespace rocinante
