#include "core/base/playback_speed.h"

#include <charconv>
#include <limits>
#include <numeric>
#include <optional>

namespace rocinante {
namespace {

__extension__ using Wide = __int128;

std::optional<std::int64_t> parseDigits(std::string_view text) {
  if (text.empty() || text.size() > 9) return std::nullopt;
  std::int64_t number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, number);
  if (fault != std::errc{} || stop != end || number < 0) return std::nullopt;
  return number;
}

Error badSpeed(std::string_view text) {
  return {ErrorKind::bad_argument, "a speed is a number from 0.01 to 1000, such as 0.25, 2 or 3/2",
          std::string(text)};
}

Nanoseconds scaled(Nanoseconds duration, std::int64_t times, std::int64_t divided_by) {
  const std::int64_t count = duration.count();
  std::int64_t product = 0;
  if (!__builtin_mul_overflow(count, times, &product)) return Nanoseconds(product / divided_by);
  const Wide exact = static_cast<Wide>(count) * times / divided_by;
  constexpr Wide kMax = std::numeric_limits<std::int64_t>::max();
  if (exact > kMax) return Nanoseconds::max();
  if (exact < -kMax) return Nanoseconds(-std::numeric_limits<std::int64_t>::max());
  return Nanoseconds(static_cast<std::int64_t>(exact));
}

}  // namespace

Result<PlaybackSpeed> PlaybackSpeed::parse(std::string_view text) {
  std::optional<std::int64_t> log_part;
  std::optional<std::int64_t> real_part = 1;
  if (const auto slash = text.find('/'); slash != text.npos) {
    log_part = parseDigits(text.substr(0, slash));
    real_part = parseDigits(text.substr(slash + 1));
  } else {
    const auto dot = text.find('.');
    const std::string_view decimals = dot == text.npos ? "" : text.substr(dot + 1);
    // "2." would look as if a digit had been lost.
    if (dot != text.npos && decimals.empty()) return badSpeed(text);
    log_part = parseDigits(std::string(text.substr(0, dot)) + std::string(decimals));
    for (std::size_t i = 0; i < decimals.size() && i < 9; ++i) *real_part *= 10;
  }
  if (!log_part || !real_part || *log_part == 0 || *real_part == 0) return badSpeed(text);
  if (*log_part > 1000 * *real_part || 100 * *log_part < *real_part) return badSpeed(text);
  const std::int64_t common = std::gcd(*log_part, *real_part);
  return PlaybackSpeed(*log_part / common, *real_part / common);
}

Nanoseconds PlaybackSpeed::realDuration(Nanoseconds recorded) const {
  return scaled(recorded, real_part_, log_part_);
}

Nanoseconds PlaybackSpeed::logDuration(Nanoseconds real) const {
  return scaled(real, log_part_, real_part_);
}

std::string PlaybackSpeed::text() const {
  if (real_part_ == 1) return std::to_string(log_part_);
  std::int64_t tenths = 1;
  std::size_t decimals = 0;
  while (tenths % real_part_ != 0 && decimals < 9) {
    tenths *= 10;
    ++decimals;
  }
  const std::int64_t whole = log_part_ / real_part_;
  if (tenths % real_part_ == 0) {
    std::string digits = std::to_string(log_part_ % real_part_ * (tenths / real_part_));
    digits.insert(0, decimals - digits.size(), '0');
    std::string decimal = std::to_string(whole) + "." + digits;
    // parse() takes nine digits in all; a decimal with more is shorter as a ratio.
    if (decimal.size() <= 10) return decimal;
  }
  return std::to_string(log_part_) + "/" + std::to_string(real_part_);
}

}  // namespace rocinante
