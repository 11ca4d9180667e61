#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/cell/cell.h"
#include "core/series/series_scan.h"

namespace rocinante {

/// What of the plots is to be written as a table.
struct TableQuery {
  std::vector<SeriesKey> keys;
  LogTime from{}, until{};
  std::filesystem::path path;
};

/// The log of a study. Borrowed.
struct TableSource {
  const Cell& cell;
  const PositionalNames& names;
  const std::filesystem::path& log;
  LogTime start{};        ///< of the log
  const SeriesScan& all;  ///< of all of it
  std::function<Result<SessionState>(LogTime)> state_at;
  std::function<bool()> goes_on;  ///< false: it is to stop
};

/// Writes the table (core/series/series_table.h), and says how it went: a sentence, with the texts
/// that are left out.
Result<std::string> writePlottedTable(const TableQuery& wish, const TableSource& source);

}  // namespace rocinante
