#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/bundle/cell_bundle.h"
#include "core/bundle/cell_or_log.h"
#include "core/cell/cell.h"
#include "core/log/log_reader.h"

namespace rocinante {

/// Whether it carries one, whole or not.
bool carriesCell(const LogReader& log);

/// The cell that a log carries, read whole and checked: every size, checksum and SHA-256. Empty
/// when the log has none; damaged when it should have one, naming the attachment. Of several cells
/// the first is used.
Result<std::optional<CellBundle>> readAttachedCell(const LogReader& log);

/// The bundle of a program's cell argument: collectCell(), or the cell that a log carries.
Result<CellBundle> collectCellOrLog(const std::filesystem::path& path, const CellOptions& options,
                                    BundleRoots roots = BundleRoots::of_user);

}  // namespace rocinante
