#include "core/recording/session_clock.h"

#include <algorithm>

namespace rocinante {
namespace {

constexpr Nanoseconds kStep = std::chrono::milliseconds(1);
// The program was interrupted during a wider reading: it is less exact than half a step.
constexpr Nanoseconds kLookTooWide = std::chrono::microseconds(500);
constexpr Nanoseconds kNarrowLook = std::chrono::microseconds(2);

SteadyTime middleOf(const ClockReading& reading) {
  return reading.before + (reading.after - reading.before) / 2;
}

}  // namespace

ClockReading readClocks() {
  // An interrupted reading measures the offset poorly.
  ClockReading best{};
  for (int attempt = 0; attempt < 4; ++attempt) {
    ClockReading reading;
    reading.before = std::chrono::steady_clock::now();
    reading.wall = std::chrono::time_point_cast<Nanoseconds>(std::chrono::system_clock::now());
    reading.after = std::chrono::steady_clock::now();
    const bool narrower = reading.after - reading.before < best.after - best.before;
    if (attempt == 0 || narrower) best = reading;
    if (best.after - best.before <= kNarrowLook) break;
  }
  return best;
}

SessionClock::SessionClock(const ClockReading& first)
    : first_steady_(middleOf(first)),
      first_wall_(first.wall),
      now_(first.wall.time_since_epoch()),
      looked_at_(now_),
      uncertainty_((first.after - first.before) / 2) {}

LogTime SessionClock::at(SteadyTime moment) const {
  return LogTime(first_wall_.time_since_epoch() + (moment - first_steady_));
}

std::optional<ClockStep> SessionClock::observe(const ClockReading& reading) {
  now_ = std::max(now_, at(reading.after));
  const Nanoseconds width = reading.after - reading.before;
  if (width > kLookTooWide) return std::nullopt;

  const LogTime moment = at(middleOf(reading));
  const LogTime looked_before = looked_at_;
  looked_at_ = moment;
  const Nanoseconds drift = reading.wall.time_since_epoch() - moment.time_since_epoch();
  const Nanoseconds moved = drift - drift_;
  // Within the uncertainty of the readings nothing moved: spacings stay the kernel's own, to the
  // nanosecond.
  if (std::chrono::abs(moved) <= uncertainty_ + width / 2) return std::nullopt;

  uncertainty_ = width / 2;
  if (std::chrono::abs(moved) <= kStep) {
    drift_ = drift;
    return std::nullopt;
  }
  drift_before_ = drift_;
  drift_ = drift;
  step_after_ = looked_before;
  return ClockStep{moment, moved};
}

LogTime SessionClock::at(WallTime stamp) const {
  LogTime moment(stamp.time_since_epoch() - drift_);
  // A stamp from before the step could have happened, or from the future, is older than the step.
  if (step_after_ && (moment < *step_after_ || moment > now_)) {
    moment = LogTime(stamp.time_since_epoch() - drift_before_);
  }
  return std::min(moment, now_);
}

}  // namespace rocinante
