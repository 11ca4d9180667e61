#include "core/foreign/table/table_fields.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <span>

#include "core/base/bytes.h"
#include "core/base/duration_text.h"
#include "core/base/plain_text.h"
#include "core/foreign/table/table_column.h"
#include "core/packet/packet_limits.h"
#include "core/packet/text_number.h"

namespace rocinante {
namespace {

/// Numbers of packet text are below.
constexpr double kTableBound = 0x1p53;
constexpr auto kNoValues = std::to_array<std::string_view>(
    {"",     "-",    "--",       "---",       "n/a",       "na",        "#n/a", "<na>", "nan",
     "+nan", "-nan", "nan(ind)", "-nan(ind)", "1.#qnan",   "-1.#ind",   "null", "none", "nil",
     "inf",  "+inf", "-inf",     "infinity",  "+infinity", "-infinity", "?"});
constexpr std::size_t kLongestWord = 9;
constexpr std::array<std::string_view, 1> kTrue = {"true"};
constexpr std::array<std::string_view, 1> kFalse = {"false"};

/// In any case.
bool isOneOf(std::span<const std::string_view> words, std::string_view text) {
  if (text.size() > kLongestWord) return false;
  std::array<char, kLongestWord> low{};
  std::ranges::transform(text, low.begin(), [](char each) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(each)));
  });
  return std::ranges::find(words, std::string_view(low.data(), text.size())) != words.end();
}

bool isDigitOrSign(char each) { return (each >= '0' && each <= '9') || each == '+' || each == '-'; }

/// A time on the calendar; without a zone it is UTC.
std::optional<Nanoseconds> dateTime(std::string_view text) {
  if (text.size() < 19 || text.size() > 48 || text[4] != '-') return std::nullopt;
  std::string whole(text);
  const std::string_view clock = text.substr(19);
  if (clock.find_first_of("Zz+-") == clock.npos) whole += 'Z';
  // "+0100" and "+01"
  const std::size_t zone = whole.find_first_of("+-", 19);
  if (zone != whole.npos && whole.size() == zone + 3) whole += "00";
  if (zone != whole.npos && whole.size() == zone + 5) whole.insert(zone + 3, ":");
  const Result<WallTime> time = parseRfc3339(whole);
  if (!time) return std::nullopt;
  return time->time_since_epoch();
}

/// By the digits before the point, as of a time since 1970: seconds have ten of them until 2286.
TimeUnit unitOf(std::string_view number) {
  const std::string_view whole = number.substr(0, number.find('.'));
  if (whole.find_first_of("eE") != whole.npos) return TimeUnit::seconds;
  const std::size_t first = std::min(whole.find_first_not_of("+-0"), whole.size());
  const std::size_t digits = whole.size() - first;
  if (digits <= 11) return TimeUnit::seconds;
  if (digits <= 14) return TimeUnit::milliseconds;
  return digits <= 17 ? TimeUnit::microseconds : TimeUnit::nanoseconds;
}

}  // namespace

bool isNoValue(std::string_view text) { return isOneOf(kNoValues, text); }

bool isSignalText(std::string_view text) {
  const auto can_be_stated = [](char each) {
    return each == '\t' || each == '\n' || !isControl(each);
  };
  return text.size() <= limits::kStringBytes && std::ranges::all_of(text, can_be_stated) &&
         isUtf8(bytesOf(text));
}

std::string_view TableNumbers::withPoint(std::string_view text) {
  if (decimal_ == '.') return text;
  const std::size_t sign = text.find_first_of(".,");
  if (sign == text.npos || text.find_first_of(".,", sign + 1) != text.npos) return text;
  if (!std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(sign), isDigitOrSign)) {
    return text;
  }
  if (decimal_ == '\0') decimal_ = text[sign];
  if (decimal_ == '.') return text;
  pointed_ = text;
  // In a table with decimal commas a point is nothing that a number has.
  pointed_[sign] = text[sign] == ',' ? '.' : ',';
  return pointed_;
}

TableValue TableNumbers::read(std::string_view text, double& number) {
  const std::string_view plain = withPoint(text);
  const char* at = plain.data();
  const char* const end = at + plain.size();
  if (readNumber(at, end, number) && at == end) {
    return std::abs(number) < kTableBound ? TableValue::number : TableValue::text;
  }
  return isNoValue(text) ? TableValue::nothing : TableValue::text;
}

std::optional<SignalValue> TableNumbers::readSignal(std::string_view text) {
  SignalValue value;
  const std::string_view plain = withPoint(text);
  const char* at = plain.data();
  const char* const end = at + plain.size();
  if (readNumber(at, end, value.number) && at == end) return value;
  if (isNoValue(text)) return std::nullopt;
  const bool is_true = isOneOf(kTrue, text);
  if (is_true || isOneOf(kFalse, text)) {
    return SignalValue{SignalKind::boolean, is_true ? 1.0 : 0.0, {}, {}};
  }
  return SignalValue{SignalKind::text, 0, std::string(text), {}};
}

std::optional<Nanoseconds> TableTimes::read(std::string_view text) {
  if (unit_ == TimeUnit::unknown || unit_ == TimeUnit::seconds) {
    if (const auto date = dateTime(text)) return date;
  }
  if (unit_ == TimeUnit::unknown) {
    // One unit for all of its rows.
    if (!tableSeconds(text, 9)) return std::nullopt;
    unit_ = unitOf(text);
  }
  switch (unit_) {
    case TimeUnit::unknown:
    case TimeUnit::seconds:
      return tableSeconds(text);
    case TimeUnit::milliseconds:
      return tableSeconds(text, 3);
    case TimeUnit::microseconds:
      return tableSeconds(text, 6);
    case TimeUnit::nanoseconds:
      return tableSeconds(text, 9);
  }
  return std::nullopt;
}

}  // namespace rocinante
