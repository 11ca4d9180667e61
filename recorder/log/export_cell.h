#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "core/cell/cell.h"
#include "core/log/log_reader.h"

namespace CLI {
class App;
}

namespace rocinante {

/// The cell that a log is exported with: the one that is named, else the one that the log carries.
struct ExportCellArguments {
  std::filesystem::path cell;
  CellOptions search;
};

/// `name` is of the option or argument: "--cell", "CELL".
void addExportCellArguments(CLI::App& app, const char* name, ExportCellArguments& arguments);

/// Empty when none is named and the log carries none. Faults of the cell are named on standard
/// error. `geometry` reads the meshes too.
Result<std::shared_ptr<const Cell>> loadExportCell(const ExportCellArguments& arguments,
                                                   const LogReader& log, bool geometry);

}  // namespace rocinante
