#include "recorder/log/export_cell.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "core/bundle/attached_cell.h"
#include "core/bundle/cell_or_log.h"
#include "core/cli/load_progress.h"
#include "core/cli/program.h"
#include "core/cli/search_options.h"
#include "core/cli/worker_threads.h"

namespace rocinante {

void addExportCellArguments(CLI::App& app, const char* name, ExportCellArguments& arguments) {
  CLI::Option* const cell =
      app.add_option(name, arguments.cell,
                     "the cell or model of the session; by default the one that the log carries");
  if (!cell->get_positional()) cell->type_name("CELL");
  cli::addSearchOptions(app, arguments.search);
}

Result<std::shared_ptr<const Cell>> loadExportCell(const ExportCellArguments& arguments,
                                                   const LogReader& log, bool geometry) {
  std::filesystem::path path = arguments.cell;
  if (path.empty()) {
    const std::vector<std::string> words = cli::searchWords(arguments.search);
    if (!words.empty()) return Error{ErrorKind::bad_argument, words.front() + " needs a cell", {}};
    if (!carriesCell(log)) return std::shared_ptr<const Cell>();
    path = log.name();
  }
  CellOptions options = arguments.search;
  options.geometry = geometry;
  options.parallel = cli::workerThreads();
  options.progress = cli::loadProgress(path.string());
  Result<Cell> cell = loadCellOrLog(path, options);
  if (!cell) return cell.error();
  for (const Finding& fault : cell->faults) {
    if (fault.severity == Severity::error) cli::warn(cell->shown(fault.print()));
  }
  return std::make_shared<const Cell>(std::move(*cell));
}

}  // namespace rocinante
