#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/foreign/table/session_table.h"
#include "core/foreign/table/table_writer.h"
#include "core/report/account.h"
#include "core/session/moment_walk.h"
#include "recorder/export/clearance_columns.h"

namespace rocinante {

/// Receives how much is done, 0 to 1; an error ends the work.
using ExportProgress = std::function<Status(double)>;

struct TableOptions {
  enum class Rows {
    written,  ///< at each moment that writes a device of the table
    changed,  ///< of those, where a value differs from the row before
    grid,     ///< at each `every`, from `from` on
  } rows = Rows::written;
  Nanoseconds every{};  ///< grid: above 0
  LogTime from{}, until{};
  ExportProgress progress;                 ///< may be empty
  ClearanceColumns* clearances = nullptr;  ///< behind the other columns; borrowed
};

struct TableReport {
  std::uint64_t rows = 0;
  std::vector<std::string> columns;
  Account left_out;  ///< what has no column
};

/// Writes the states of a session in [from, until) as a table. Two passes over the log: one finds
/// the columns, one writes the rows. not_found when no chosen device has joints or a pose.
Result<TableReport> writeTable(MomentWalk& session, SessionTable& table, TableWriter& writer,
                               const TableOptions& options);

}  // namespace rocinante
