#include "core/foreign/table/table_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>

#include "core/base/plain_text.h"
#include "core/foreign/table/csv_line.h"
#include "core/foreign/table/table_fields.h"

namespace rocinante {
namespace {

constexpr std::string_view kSeparators = ",;\t ";
constexpr std::size_t kMaxColumns = 100'000;
constexpr std::size_t kMaxNamedColumns = 8;

struct UnitName {
  std::string_view name;
  TimeUnit unit;
};
constexpr auto kUnits = std::to_array<UnitName>({
    {"s", TimeUnit::seconds},
    {"sec", TimeUnit::seconds},
    {"secs", TimeUnit::seconds},
    {"seconds", TimeUnit::seconds},
    {"ms", TimeUnit::milliseconds},
    {"msec", TimeUnit::milliseconds},
    {"millis", TimeUnit::milliseconds},
    {"milliseconds", TimeUnit::milliseconds},
    {"us", TimeUnit::microseconds},
    {"usec", TimeUnit::microseconds},
    {"micros", TimeUnit::microseconds},
    {"microseconds", TimeUnit::microseconds},
    {"ns", TimeUnit::nanoseconds},
    {"nsec", TimeUnit::nanoseconds},
    {"nanos", TimeUnit::nanoseconds},
    {"nanoseconds", TimeUnit::nanoseconds},
});
// The first of these that a table has is its time, unless one in nanoseconds is there, too.
constexpr std::array<std::string_view, 5> kPlainTimes = {"t", "time", "__time", "timestamp",
                                                         "stamp"};

std::string lowered(std::string_view name) {
  std::string low;
  for (const char each : name) {
    low += static_cast<char>(std::tolower(static_cast<unsigned char>(each)));
  }
  return low;
}

bool isBlankLine(std::string_view line) { return line.find_first_not_of(" \t") == line.npos; }

/// The time among the names, the best one.
void findTime(TableHeader& header) {
  std::size_t best = kPlainTimes.size() + 3;
  for (std::size_t i = 0; i < header.names.size(); ++i) {
    const auto unit = timeUnitOf(header.names[i]);
    if (!unit) continue;
    const auto plain = std::ranges::find(kPlainTimes, lowered(header.names[i]));
    // Nanoseconds are exact where both are given.
    std::size_t rank = *unit == TimeUnit::nanoseconds ? 0 : kPlainTimes.size() + 2;
    if (plain != kPlainTimes.end()) {
      rank = 1 + static_cast<std::size_t>(plain - kPlainTimes.begin());
    }
    if (rank >= best) continue;
    best = rank;
    header.time = i;
    header.unit = *unit;
  }
}

/// The header that a line is with this separator, with or without a time; empty when it is none.
std::optional<TableHeader> headerWith(std::string_view line, char separator) {
  std::vector<CsvField> fields;
  if (!splitCsvLine(line, fields, separator) || fields.size() < 2 || fields.size() > kMaxColumns) {
    return std::nullopt;
  }
  TableHeader header;
  header.separator = separator;
  for (const CsvField& field : fields) {
    std::string& name = header.names.emplace_back(field.unescaped());
    if (std::ranges::any_of(name, isControl)) return std::nullopt;
    if (!name.empty() && !(header.names.size() == 1 && name.starts_with("Unnamed:"))) continue;
    // A table with several is another's layout, not an index.
    if (header.names.size() > 1) return std::nullopt;
    header.index = 0;
  }
  findTime(header);
  const auto find = [&](std::string_view wanted) {
    const auto found = std::ranges::find(header.names, wanted);
    return found == header.names.end() ? TableHeader::kNone
                                       : static_cast<std::size_t>(found - header.names.begin());
  };
  header.device = find("device");
  header.joint = find("joint") != TableHeader::kNone ? find("joint") : find("name");
  header.value = find("value") != TableHeader::kNone ? find("value") : find("position");
  return header;
}

/// The header that a line is, with a time.
std::optional<TableHeader> headerIn(std::string_view line) {
  for (const char separator : kSeparators) {
    auto header = headerWith(line, separator);
    if (header && header->time != TableHeader::kNone) return header;
  }
  return std::nullopt;
}

/// How many fields of a row are numbers; empty when it has another number of fields.
std::optional<std::size_t> numbersIn(std::string_view line, const TableHeader& header) {
  std::vector<CsvField> fields;
  if (!splitCsvLine(line, fields, header.separator) || fields.size() != header.names.size()) {
    return std::nullopt;
  }
  TableNumbers numbers(header.separator);
  double ignored = 0;
  return static_cast<std::size_t>(std::ranges::count_if(fields, [&](const CsvField& field) {
    return numbers.read(field.text, ignored) == TableValue::number;
  }));
}

/// Whether the row has a field for each name, and a time where the header says.
bool fitsRow(const TableHeader& header, std::string_view row) {
  std::vector<CsvField> fields;
  if (!splitCsvLine(row, fields, header.separator) || fields.size() != header.names.size()) {
    return false;
  }
  TableNumbers numbers(header.separator);
  return TableTimes(header.unit).read(numbers.withPoint(fields[header.time].text)).has_value();
}

std::string_view withoutHash(std::string_view line) {
  const std::size_t begin = line.find_first_not_of("# \t");
  return begin == line.npos ? std::string_view() : line.substr(begin);
}

std::string columnsText(const TableHeader& header) {
  std::string text;
  for (std::size_t i = 0; i < std::min(header.names.size(), kMaxNamedColumns); ++i) {
    std::string name = plainText(header.names[i].substr(0, 64));
    text += fmt::format("{}`{}`", i > 0 ? ", " : "", name);
  }
  const std::size_t more = header.names.size() - std::min(header.names.size(), kMaxNamedColumns);
  return more == 0 ? text : fmt::format("{} and {} more", text, more);
}

/// What the line lacks to be a header.
std::string whatIsMissing(std::string_view line) {
  std::optional<TableHeader> most;
  for (const char separator : kSeparators) {
    auto header = headerWith(line, separator);
    // Blanks separate only what nothing else does.
    if (header && (!most || (separator != ' ' && header->names.size() > most->names.size()))) {
      most = std::move(header);
    }
  }
  if (!most) {
    return "its first line is not a header with names of columns, separated by commas, semicolons, "
           "tabs or blanks, one of them the time (" +
           std::string(kTimeNames) + ")";
  }
  if (numbersIn(line, *most) == most->names.size()) {
    return "it has no header: a first line names the columns, one of them the time (" +
           std::string(kTimeNames) + ")";
  }
  return fmt::format("no column is the time ({}): the columns are {}", kTimeNames,
                     columnsText(*most));
}

}  // namespace

std::optional<TimeUnit> timeUnitOf(std::string_view name) {
  std::string low = lowered(name);
  while (!low.empty() && (low.front() == '%' || low.front() == ' ')) low.erase(0, 1);
  // As `rostopic echo -p` writes it.
  if (name.starts_with('%') && low == "time") return TimeUnit::nanoseconds;
  if (std::ranges::find(kPlainTimes, low) != kPlainTimes.end()) return TimeUnit::unknown;
  const std::size_t end = low.find_last_not_of(")] ");
  const std::size_t begin = low.find_last_of("_([ ", end);
  if (end == low.npos || begin == low.npos || begin == 0) return std::nullopt;
  const std::size_t base = low.find_last_not_of("_([ ", begin);
  if (base == low.npos ||
      std::ranges::find(kPlainTimes, low.substr(0, base + 1)) == kPlainTimes.end()) {
    return std::nullopt;
  }
  const std::string unit = low.substr(begin + 1, end - begin);
  const auto found = std::ranges::find(kUnits, unit, &UnitName::name);
  return found == kUnits.end() ? std::nullopt : std::optional(found->unit);
}

bool isTableRemark(std::string_view line) { return isBlankLine(line) || line.starts_with('#'); }

std::vector<std::string_view> firstLinesOf(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::vector<std::string_view> lines;
  while (lines.size() < kMaxHeaderLines) {
    const auto line = takeLine(text);
    if (!line) break;
    lines.push_back(*line);
  }
  return lines;
}

Result<TableHeader> tableHeader(std::span<const std::string_view> first_lines) {
  std::optional<TableHeader> in_comment;
  for (std::size_t i = 0; i < first_lines.size(); ++i) {
    const std::string_view line = first_lines[i];
    if (isBlankLine(line)) continue;
    if (line.starts_with('#')) {
      if (auto header = headerIn(withoutHash(line))) {
        in_comment = std::move(header);
        in_comment->line = i;
      }
      continue;
    }
    // A sentence with the word "time" is no header, unless the first row fits it.
    if (in_comment && fitsRow(*in_comment, line)) return *in_comment;
    auto header = headerIn(line);
    // Blanks are in every text: only with its first row it is a table.
    if (header && header->separator == ' ') {
      const auto row = std::find_if(first_lines.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                    first_lines.end(), std::not_fn(isTableRemark));
      if (row == first_lines.end() || !fitsRow(*header, *row)) header.reset();
    }
    if (header) {
      header->line = i;
      return *header;
    }
    return Error{ErrorKind::bad_argument, whatIsMissing(line), {}};
  }
  return Error{ErrorKind::bad_argument, "it has no row", {}};
}

std::optional<std::string> tableRefusal(std::string_view text) {
  const std::vector<std::string_view> lines = firstLinesOf(text);
  std::vector<std::string_view> rows;
  for (const std::string_view line : lines) {
    if (!isTableRemark(line)) rows.push_back(line);
  }
  if (rows.size() < 2) return std::nullopt;
  const bool has_columns = std::ranges::any_of(kSeparators, [&](char separator) {
    // "x = [1, 2, 3]" and "{" begin other texts.
    if (rows[0].find_first_of("={<") != rows[0].npos) return false;
    const auto header = headerWith(rows[0], separator);
    // Blanks are in every text: a row of numbers alone is none.
    const std::size_t least = header && separator == ' ' ? header->names.size() : 1;
    return header && numbersIn(rows[1], *header).value_or(0) >= least;
  });
  if (!has_columns) return std::nullopt;
  const auto header = tableHeader(lines);
  if (header) return std::nullopt;
  return "the table cannot be read: " + header.error().what;
}

}  // namespace rocinante
