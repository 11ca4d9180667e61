#include "viewer/ui/panels/time_ruler.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace rocinante {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kMinute = 60 * kSecond;
constexpr std::int64_t kHour = 60 * kMinute;
constexpr std::int64_t kDay = 24 * kHour;

}  // namespace

Nanoseconds rulerStep(Nanoseconds span, double width_px, double label_px) {
  const double least = static_cast<double>(std::max<std::int64_t>(span.count(), 1)) * label_px /
                       std::max(width_px, 1.0);
  const auto enough = [least](std::int64_t step) { return static_cast<double>(step) >= least; };
  for (std::int64_t power = 1; power < kSecond; power *= 10) {
    for (const std::int64_t factor : {1, 2, 5}) {
      if (enough(factor * power)) return Nanoseconds(factor * power);
    }
  }
  for (const std::int64_t unit : {kSecond, kMinute, kHour}) {
    for (const std::int64_t factor : {1, 2, 5, 10, 15, 30}) {
      if (factor * unit < kDay && enough(factor * unit)) return Nanoseconds(factor * unit);
    }
  }
  std::int64_t days = kDay;
  while (!enough(days) && days < std::numeric_limits<std::int64_t>::max() / 2) days *= 2;
  return Nanoseconds(days);
}

std::string rulerLabel(Nanoseconds since_origin, Nanoseconds step) {
  const std::int64_t count = since_origin.count();
  const std::uint64_t size = count < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(count)
                                       : static_cast<std::uint64_t>(count);
  const char* const sign = count < 0 ? "-" : "";
  const std::uint64_t seconds = size / kSecond;
  int decimals = 0;
  for (std::int64_t unit = kSecond; unit > 1 && step.count() % unit != 0; unit /= 10) ++decimals;
  std::string rest;
  if (decimals > 0)
    rest = fmt::format(".{:09}", size % kSecond).substr(0, 1 + static_cast<std::size_t>(decimals));
  if (seconds < 60) return fmt::format("{}{}{}", sign, seconds, rest);
  if (seconds < 3600) return fmt::format("{}{}:{:02}{}", sign, seconds / 60, seconds % 60, rest);
  return fmt::format("{}{}:{:02}:{:02}{}", sign, seconds / 3600, seconds / 60 % 60, seconds % 60,
                     rest);
}

}  // namespace rocinante
