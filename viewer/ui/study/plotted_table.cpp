#include "viewer/ui/study/plotted_table.h"

#include <fmt/format.h>

#include <set>
#include <utility>

#include "core/log/log_reader.h"
#include "core/series/derived_value.h"
#include "core/series/series_table.h"
#include "viewer/ui/study/study_picture.h"

namespace rocinante {

Result<std::string> writePlottedTable(const TableQuery& wish, const TableSource& source) {
  auto [keys, left_out] = tableKeys(wish.keys, source.all);
  SeriesTable table{.keys = std::move(keys),
                    .from = wish.from,
                    .until = wish.until,
                    .names = source.names,
                    .cell = &source.cell,
                    .goes_on = source.goes_on};
  const std::set<SeriesKey> columns(table.keys.begin(), table.keys.end());
  if (const auto lead = leadOf(columns, table.from, source.start)) {
    auto state = source.state_at(*lead);
    if (!state.ok()) return state.error();
    table.lead.emplace(*lead, std::move(*state));
  }
  auto before = source.state_at(wish.from);
  if (!before.ok()) return before.error();
  auto reader = LogReader::open(source.log);
  if (!reader.ok()) return reader.error();
  const auto rows = writeSeriesTable(table, std::move(*before), *reader, wish.path);
  if (!rows.ok()) return rows.error();
  return fmt::format("{}: {} rows{}", wish.path.string(), *rows, left_out);
}

}  // namespace rocinante
