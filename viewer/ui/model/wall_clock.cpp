#include "viewer/ui/model/wall_clock.h"

#include <chrono>

#include "core/base/duration_text.h"

namespace rocinante {
namespace {

/// "2026-11-21T05:12:07.930377919Z"
std::string textOf(LogTime moment) { return rfc3339Text(WallTime(moment.time_since_epoch())); }

}  // namespace

bool hasWallClock(LogTime origin) {
  using namespace std::chrono_literals;
  return WallTime(origin.time_since_epoch()) >= std::chrono::sys_days(2000y / 1 / 1);
}

std::string clockText(LogTime moment) { return textOf(moment).substr(11, 12); }

std::string calendarText(LogTime moment) {
  return textOf(moment).substr(0, 10) + " " + clockText(moment) + " UTC";
}

std::string clockLabel(LogTime moment, Nanoseconds step) {
  using namespace std::chrono_literals;
  const std::string text = textOf(moment);
  if (step >= 24h) return text.substr(5, 5);
  if (step >= 1min) return text.substr(11, 5);
  if (step >= 1s) return text.substr(11, 8);
  std::size_t decimals = 1;
  for (Nanoseconds unit = 100ms; unit > 1ns && step % unit != 0ns; unit /= 10) ++decimals;
  return text.substr(14, 6 + decimals);
}

}  // namespace rocinante
