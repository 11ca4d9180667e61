#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

/// The header of a table that any program wrote (docs/other-formats.md, "Tables and JSON lines").
namespace rocinante {

/// `unknown`: the first time tells, by its digits.
enum class TimeUnit : std::uint8_t { unknown, seconds, milliseconds, microseconds, nanoseconds };

/// For sentences about what has no time.
inline constexpr std::string_view kTimeNames =
    "`t`, `time`, `timestamp`, `stamp` or `__time`, perhaps with a unit: `time_ms`";

/// What a column or key is called that holds the time: "t", "__time", "timestamp [ns]", "time_ms";
/// empty for any other. Cases make no difference.
std::optional<TimeUnit> timeUnitOf(std::string_view name);

struct TableHeader {
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  std::size_t line = 0;  ///< of the lines that were given: the rows are behind it
  char separator = ',';  ///< ',', ';', a tab, or ' ' for any number of blanks
  std::vector<std::string> names;
  std::size_t time = kNone;
  TimeUnit unit = TimeUnit::unknown;
  std::size_t index = kNone;  ///< row numbers without a name, as pandas writes them
  /// Of the long form: a value a row.
  std::size_t device = kNone, joint = kNone, value = kNone;

  bool isLong() const { return joint != kNone && value != kNone; }
};

/// Finds the header in the first lines of a text. Lines that begin with '#' are comments, and the
/// header may be one of them. bad_argument with a sentence that names what is missing.
Result<TableHeader> tableHeader(std::span<const std::string_view> first_lines);

/// The lines that tableHeader() needs at most.
inline constexpr std::size_t kMaxHeaderLines = 64;
std::vector<std::string_view> firstLinesOf(std::string_view text);

/// Why a text that has rows and columns is no table that can be read; empty for any other text.
std::optional<std::string> tableRefusal(std::string_view text);

/// Whether the line is blank or a comment, and so no row.
bool isTableRemark(std::string_view line);

}  // namespace rocinante
