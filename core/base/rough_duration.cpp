#include "core/base/rough_duration.h"

#include <fmt/format.h>

#include <array>

namespace rocinante {

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

}  // namespace rocinante
