#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/log/log_reader.h"
#include "core/series/series_scan.h"

namespace rocinante {

/// Writes joints, poses, links, numbers of signals and what is derived of them from a stretch of a
/// log as the table that `rocinante source --csv` reads (docs/programs/source.md): column `t` in
/// seconds from the session's origin, then one per key, in radians, metres and the signals' units,
/// the shortest numbers that read back as the same. The first row has what holds at `from`; then
/// there is one for every packet about one of the devices, or with a sample of which something is
/// derived, until `until`. A field is empty while no packet has stated the value. One pass, twice
/// folded where something is derived; the file is replaced whole or not at all.
struct SeriesTable {
  std::vector<SeriesKey> keys;  ///< at least one, none of a source's counts
  LogTime from{}, until{};
  PositionalNames names;
  const Cell* cell = nullptr;  ///< of links; borrowed
  /// Of derived values: the state at leadOf() (derived_value.h).
  std::optional<std::pair<LogTime, SessionState>> lead{};
  /// Asked now and then; when it returns false, nothing is written. May be empty.
  std::function<bool()> goes_on;
};

/// The largest table: it is made in memory.
inline constexpr std::size_t kMaxTableBytes = std::size_t{256} << 20U;

/// The number of rows. `before`: the state at `from`. bad_argument for a key that is of no device,
/// or when the table would be too large; refused when it was told to stop; else why the file cannot
/// be written.
Result<std::uint64_t> writeSeriesTable(const SeriesTable& table, SessionState before,
                                       LogReader& log, const std::filesystem::path& path);

}  // namespace rocinante
