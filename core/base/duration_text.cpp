#include "core/base/duration_text.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/base/plain_text.h"

namespace rocinante {
namespace {

__extension__ using Wide = __int128;

struct Unit {
  std::string_view name;
  std::int64_t nanoseconds;
};

// A unit that starts with another unit comes before it.
constexpr std::array kUnits{Unit{"ns", 1},
                            Unit{"us", 1'000},
                            Unit{"ms", 1'000'000},
                            Unit{"s", 1'000'000'000},
                            Unit{"m", 60'000'000'000},
                            Unit{"h", 3'600'000'000'000}};

Error badDuration(std::string_view text) {
  return {ErrorKind::bad_argument,
          "a duration is a number with a unit, such as 12.5s, 250ms or 1m02.5s", std::string(text)};
}

/// Reads digits with an optional fraction off the front of `text`, times `unit` nanoseconds.
/// `unit` is known only after the digits, so both are returned as a fraction of 10^18ths.
struct Decimal {
  Wide digits = 0;
  std::int64_t divisor = 1;
};

std::optional<Decimal> takeDecimal(std::string_view& text) {
  Decimal number;
  std::size_t used = 0;
  std::size_t digit_count = 0;
  bool fraction = false;
  for (; used < text.size(); ++used) {
    const char c = text[used];
    if (c == '.' && !fraction) {
      fraction = true;
      continue;
    }
    if (!isDigit(c)) break;
    if (++digit_count > 30) return std::nullopt;
    if (fraction) {
      if (number.divisor > 100'000'000'000'000'000) return std::nullopt;
      number.divisor *= 10;
    }
    number.digits = number.digits * 10 + (c - '0');
  }
  if (digit_count == 0) return std::nullopt;
  text.remove_prefix(used);
  return number;
}

std::optional<int> takeInt(std::string_view& text, std::size_t digits) {
  if (text.size() < digits) return std::nullopt;
  int number = 0;
  for (std::size_t i = 0; i < digits; ++i) {
    if (!isDigit(text[i])) return std::nullopt;
    number = number * 10 + (text[i] - '0');
  }
  text.remove_prefix(digits);
  return number;
}

bool takeChar(std::string_view& text, char wanted) {
  if (text.empty() || text.front() != wanted) return false;
  text.remove_prefix(1);
  return true;
}

}  // namespace

std::string roughDuration(Nanoseconds duration) {
  struct Unit {
    std::int64_t seconds;
    const char* name;
  };
  constexpr std::array kLongUnits = {Unit{31'556'952, "years"}, Unit{86'400, "days"},
                                     Unit{3'600, "hours"}};
  const auto seconds = std::chrono::duration<double>(duration).count();
  for (const Unit& unit : kLongUnits) {
    const double count = seconds / static_cast<double>(unit.seconds);
    if (count >= 2) return fmt::format("{:.1f} {}", count, unit.name);
  }
  return fmt::format("{:.0f} s", seconds);
}

Result<Nanoseconds> parseDuration(std::string_view whole) {
  std::string_view text = whole;
  const bool negative = takeChar(text, '-');
  if (text.empty()) return badDuration(whole);

  Wide total = 0;
  std::int64_t previous_unit = std::numeric_limits<std::int64_t>::max();
  while (!text.empty()) {
    const auto number = takeDecimal(text);
    if (!number) return badDuration(whole);
    std::int64_t unit = 1'000'000'000;
    if (text.empty()) {
      // A bare number is seconds, alone or after minutes.
      if (previous_unit <= unit) return badDuration(whole);
    } else {
      bool known = false;
      for (const Unit& candidate : kUnits) {
        if (text.starts_with(candidate.name)) {
          unit = candidate.nanoseconds;
          text.remove_prefix(candidate.name.size());
          known = true;
          break;
        }
      }
      if (!known || unit >= previous_unit) return badDuration(whole);
    }
    previous_unit = unit;
    constexpr Wide kMax = std::numeric_limits<std::int64_t>::max();
    if (number->digits > kMax * number->divisor / unit) return badDuration(whole);
    const Wide scaled = number->digits * unit;
    if (scaled % number->divisor != 0) {
      return Error{ErrorKind::bad_argument, "a duration is exact to the nanosecond and no finer",
                   std::string(whole)};
    }
    total += scaled / number->divisor;
    if (total > kMax) return badDuration(whole);
  }
  const auto count = static_cast<std::int64_t>(total);
  return Nanoseconds(negative ? -count : count);
}

Result<WallTime> parseRfc3339(std::string_view whole) {
  const Error fault{ErrorKind::bad_argument,
                    "a calendar time is written as 2026-02-03T04:05:06.789Z", std::string(whole)};
  std::string_view text = whole;
  const auto year = takeInt(text, 4);
  if (!year || !takeChar(text, '-')) return fault;
  const auto month = takeInt(text, 2);
  if (!month || !takeChar(text, '-')) return fault;
  const auto day = takeInt(text, 2);
  if (!day || (!takeChar(text, 'T') && !takeChar(text, 't') && !takeChar(text, ' '))) return fault;
  const auto hour = takeInt(text, 2);
  if (!hour || !takeChar(text, ':')) return fault;
  const auto minute = takeInt(text, 2);
  if (!minute || !takeChar(text, ':')) return fault;
  const auto second = takeInt(text, 2);
  if (!second || *hour > 23 || *minute > 59 || *second > 59) return fault;

  std::int64_t nanoseconds = 0;
  if (takeChar(text, '.')) {
    std::int64_t place = 100'000'000;
    std::size_t digits = 0;
    while (!text.empty() && isDigit(text.front())) {
      if (++digits > 9) return fault;
      nanoseconds += (text.front() - '0') * place;
      place /= 10;
      text.remove_prefix(1);
    }
    if (digits == 0) return fault;
  }

  std::chrono::minutes zone{0};
  if (!takeChar(text, 'Z') && !takeChar(text, 'z')) {
    const bool east = takeChar(text, '+');
    if (!east && !takeChar(text, '-')) return fault;
    const auto zone_hour = takeInt(text, 2);
    if (!zone_hour || !takeChar(text, ':')) return fault;
    const auto zone_minute = takeInt(text, 2);
    if (!zone_minute || *zone_hour > 23 || *zone_minute > 59) return fault;
    zone = std::chrono::hours(*zone_hour) + std::chrono::minutes(*zone_minute);
    if (!east) zone = -zone;
  }
  const std::chrono::year_month_day date{std::chrono::year(*year),
                                         std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day))};
  // Nanoseconds in 64 bits reach from 1678 to 2261.
  if (!text.empty() || !date.ok() || *year < 1679 || *year > 2261) return fault;
  return WallTime(std::chrono::sys_days(date)) + std::chrono::hours(*hour) +
         std::chrono::minutes(*minute) + std::chrono::seconds(*second) - zone +
         Nanoseconds(nanoseconds);
}

std::string secondsText(Nanoseconds duration, int decimals) {
  const std::int64_t count = duration.count();
  const auto magnitude =
      count < 0 ? -static_cast<std::uint64_t>(count) : static_cast<std::uint64_t>(count);
  std::string text = fmt::format("{}{}.{:09}", count < 0 ? "-" : "", magnitude / 1'000'000'000,
                                 magnitude % 1'000'000'000);
  const std::size_t dot = text.size() - 10;
  const std::size_t least = decimals == 0 ? dot : dot + 1 + static_cast<std::size_t>(decimals);
  while (text.size() > least && (text.back() == '0' || text.back() == '.')) {
    const bool at_dot = text.back() == '.';
    text.pop_back();
    if (at_dot) break;
  }
  return text;
}

std::string rfc3339Text(WallTime time) {
  // Field by field: fmt's %S prints a fraction since version 10. Only whole seconds are multiplied,
  // so that the first representable nanoseconds can be printed too.
  constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;
  const auto seconds = std::chrono::floor<std::chrono::seconds>(time);
  const auto day = std::chrono::floor<std::chrono::days>(seconds);
  const std::chrono::year_month_day date(day);
  const std::chrono::hh_mm_ss clock(seconds - day);
  const std::int64_t fraction = time.time_since_epoch().count() % kNanosecondsPerSecond;
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:09}Z", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                     clock.hours().count(), clock.minutes().count(), clock.seconds().count(),
                     fraction < 0 ? fraction + kNanosecondsPerSecond : fraction);
}

}  // namespace rocinante
