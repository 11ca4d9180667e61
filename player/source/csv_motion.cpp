#include "player/source/csv_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "core/packet/packet_limits.h"
#include "core/packet/text_number.h"
#include "player/source/csv_line.h"

namespace rocinante {
namespace {

__extension__ using Wide = __int128;

/// Parses seconds as programs print them ("12.5", "1e-05", "0.30000000000000004"), to the nearest
/// nanosecond without going through a double. Empty for invalid or too large numbers.
std::optional<Nanoseconds> parseSeconds(std::string_view text) {
  double ignored = 0;
  const char* at = text.data();
  if (!readNumber(at, text.data() + text.size(), ignored) || at != text.data() + text.size()) {
    return std::nullopt;
  }
  bool negative = false;
  bool in_fraction = false;
  bool any_dropped = false;
  Wide digits = 0;
  int exponent = 9;  // the unit is the nanosecond
  std::size_t i = 0;
  if (text[0] == '-' || text[0] == '+') negative = text[i++] == '-';
  for (; i < text.size() && text[i] != 'e' && text[i] != 'E'; ++i) {
    if (text[i] == '.') {
      in_fraction = true;
      continue;
    }
    // 30 digits hold every possible time to well below a nanosecond.
    any_dropped = digits >= Wide{1'000'000'000'000'000} * 1'000'000'000'000'000;
    if (!any_dropped) digits = digits * 10 + (text[i] - '0');
    exponent += (any_dropped ? 1 : 0) - (in_fraction ? 1 : 0);
  }
  if (i < text.size()) {
    const bool down = text[++i] == '-';
    if (text[i] == '-' || text[i] == '+') ++i;
    int written = 0;
    for (; i < text.size(); ++i) written = std::min(written * 10 + (text[i] - '0'), 100'000);
    exponent += down ? -written : written;
  }
  constexpr Wide kMax = std::numeric_limits<std::int64_t>::max();
  for (; exponent > 0 && digits != 0; --exponent) {
    if (digits > kMax) return std::nullopt;
    digits *= 10;
  }
  int last_dropped = 0;
  for (; exponent < 0 && (digits != 0 || last_dropped != 0); ++exponent) {
    last_dropped = static_cast<int>(digits % 10);
    digits /= 10;
  }
  if (last_dropped >= 5) ++digits;
  if (digits > kMax) return std::nullopt;
  const auto count = static_cast<std::int64_t>(digits);
  return Nanoseconds(negative ? -count : count);
}

/// A field for an error message, shortened.
std::string shown(std::string_view text) {
  constexpr std::size_t kMax = 40;
  if (text.empty()) return "an empty field";
  return text.size() <= kMax ? fmt::format("`{}`", text)
                             : fmt::format("`{}...`", text.substr(0, kMax));
}

/// Reads one text; keeps its position for error messages.
class Reader {
 public:
  Reader(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

  Result<CsvMotion> read(const std::vector<std::string>& columns) {
    // A byte order mark is not part of the first column's name.
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
    if (const Status header = readHeader(columns); !header) return header.error();
    while (nextLine()) {
      if (const Status row = readRow(); !row) return row.error();
    }
    if (motion_.rows.empty()) return fault("there is no row below the header", 1);
    return std::move(motion_);
  }

 private:
  /// The next line that is not blank.
  bool nextLine() {
    while (const auto line = takeLine(rest_)) {
      ++line_;
      if (line->find_first_not_of(" \t") == line->npos) continue;
      split_ = splitCsvLine(*line, fields_);
      return true;
    }
    return false;
  }

  Error fault(std::string what, std::size_t column) const {
    return {ErrorKind::bad_argument, std::move(what),
            fmt::format("{}, line {}, column {}", name_, line_, column)};
  }
  Error badQuotes() const { return fault("a quoted field is not closed", fields_.back().column); }

  Status readHeader(const std::vector<std::string>& columns);
  Status chooseJoints(const std::vector<std::string>& columns);
  Status readRow();

  std::string_view rest_;
  const std::string& name_;
  std::size_t line_ = 0;
  std::vector<CsvField> fields_;  ///< of the current line
  bool split_ = true;

  std::vector<std::string> names_;  ///< of all columns
  std::size_t time_at_ = 0;
  std::vector<std::size_t> joints_at_;
  CsvMotion motion_;
};

Status Reader::readHeader(const std::vector<std::string>& columns) {
  if (!nextLine()) return Error{ErrorKind::bad_argument, "the file has no header row", name_};
  if (!split_) return badQuotes();
  for (const CsvField& field : fields_) {
    std::string name = field.unescaped();
    if (name.empty()) return fault("a column has no name", field.column);
    if (name.size() > limits::kNameBytes) {
      return fault("a column's name is longer than 255 bytes", field.column);
    }
    if (std::find(names_.begin(), names_.end(), name) != names_.end()) {
      return fault(fmt::format("two columns are named {}", shown(name)), field.column);
    }
    names_.push_back(std::move(name));
  }
  auto time = std::find(names_.begin(), names_.end(), "t");
  if (time == names_.end()) time = std::find(names_.begin(), names_.end(), "time");
  if (time == names_.end()) return fault("no column is named `t` or `time` (seconds)", 1);
  time_at_ = static_cast<std::size_t>(time - names_.begin());
  return chooseJoints(columns);
}

Status Reader::chooseJoints(const std::vector<std::string>& columns) {
  if (columns.empty()) {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (i != time_at_) joints_at_.push_back(i);
    }
  }
  for (const std::string& wanted : columns) {
    const auto found = std::find(names_.begin(), names_.end(), wanted);
    if (found == names_.end()) return fault(fmt::format("no column is named {}", shown(wanted)), 1);
    const auto at = static_cast<std::size_t>(found - names_.begin());
    if (std::find(joints_at_.begin(), joints_at_.end(), at) != joints_at_.end()) {
      return fault(fmt::format("column {} is chosen twice", shown(wanted)), 1);
    }
    joints_at_.push_back(at);
  }
  if (joints_at_.empty()) return fault("the table has no joint column", 1);
  if (joints_at_.size() > limits::kJointValues) {
    return fault(fmt::format("{} joints, but a packet holds at most {}", joints_at_.size(),
                             limits::kJointValues),
                 1);
  }
  for (const std::size_t at : joints_at_) motion_.joints.push_back(names_[at]);
  return {};
}

Status Reader::readRow() {
  if (!split_) return badQuotes();
  if (fields_.size() != names_.size()) {
    return fault(
        fmt::format("the row has {} fields, the header has {}", fields_.size(), names_.size()),
        fields_.back().column);
  }
  const CsvField& moment = fields_[time_at_];
  const auto time = parseSeconds(moment.text);
  if (!time) {
    return fault(fmt::format("{} is not a time in seconds", shown(moment.text)), moment.column);
  }
  if (!motion_.rows.empty() && *time < motion_.rows.back().time) {
    return fault(fmt::format("the time goes back: {} follows a later time", shown(moment.text)),
                 moment.column);
  }
  const std::size_t begin = motion_.values.size();
  for (const std::size_t at : joints_at_) {
    const CsvField& field = fields_[at];
    double ignored = 0;
    const char* read = field.text.data();
    const char* end = read + field.text.size();
    if (!readNumber(read, end, ignored) || read != end) {
      return fault(fmt::format("{} is not a number that packet text allows, in {}",
                               shown(field.text), shown(names_[at])),
                   field.column);
    }
    if (motion_.values.size() > begin) motion_.values.push_back(' ');
    motion_.values += field.text;
  }
  motion_.rows.push_back({*time, begin, motion_.values.size() - begin});
  return {};
}

}  // namespace

Result<CsvMotion> readCsvMotion(std::string_view text, const std::string& name,
                                const std::vector<std::string>& columns) {
  return Reader(text, name).read(columns);
}

}  // namespace rocinante
