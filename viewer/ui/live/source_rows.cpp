#include "viewer/ui/live/source_rows.h"

#include <fmt/format.h>

#include <algorithm>

namespace rocinante {
namespace {

constexpr double kSilenceS = 3;

const CellSource* expectedSource(const Cell& cell, const std::string& name) {
  const auto found = std::ranges::find(cell.sources, name, &CellSource::name);
  return found == cell.sources.end() ? nullptr : &*found;
}

}  // namespace

std::vector<SourceRow> sourceRows(std::span<const LiveSource> live, const Cell& cell,
                                  SteadyTime now) {
  std::vector<SourceRow> rows;
  rows.reserve(live.size() + cell.sources.size());
  for (const LiveSource& source : live) {
    SourceRow row{source.name, &source, now - source.heard, false, false, std::nullopt};
    double most_s = kSilenceS;
    if (const CellSource* expected = expectedSource(cell, source.name)) {
      most_s = expected->limits.silence_s.value_or(most_s);
      row.wanted_hz = expected->rate_hz;
    }
    row.is_silent = std::chrono::duration<double>(row.silent).count() > most_s;
    row.off_rate =
        row.wanted_hz && !row.is_silent &&
        (source.rate_hz < row.wanted_hz->first || source.rate_hz > row.wanted_hz->second);
    rows.push_back(std::move(row));
  }
  for (const CellSource& expected : cell.sources) {
    if (std::ranges::find(live, expected.name, &LiveSource::name) != live.end()) continue;
    rows.push_back({expected.name, nullptr, {}, true, false, expected.rate_hz});
  }
  std::ranges::sort(rows, {}, &SourceRow::name);
  return rows;
}

std::string ageText(Nanoseconds age) {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(age).count();
  if (seconds < 1) return "now";
  if (seconds < 60) return fmt::format("{} s", seconds);
  if (seconds < 3600) return fmt::format("{} min", seconds / 60);
  return fmt::format("{} h", seconds / 3600);
}

}  // namespace rocinante
