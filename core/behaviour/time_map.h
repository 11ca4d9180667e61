#pragma once

#include <vector>

#include "core/base/time.h"

namespace rocinante {

/// Maps times of the accepted session to another one: linear between knots, at `rate` outside.
struct TimeMap {
  struct Knot {
    LogTime accepted{}, run{};
  };
  std::vector<Knot> knots;  ///< at least one; times do not decrease on either side
  double rate = 1;          ///< of the run's clock, before the first knot and after the last

  LogTime inRun(LogTime accepted) const;
  LogTime inAccepted(LogTime run) const;
  class Walk;
};

/// Maps times that do not decrease, each in constant time. Borrows the map.
class TimeMap::Walk {
 public:
  explicit Walk(const TimeMap& map) : map_(map) {}
  LogTime inAccepted(LogTime run);

 private:
  const TimeMap& map_;
  std::size_t after_ = 0;  ///< the first knot behind the last time
};

/// The rate of a clock against another, from events that both have: the median over pairs, so that
/// an event that is late does not count. 1 when it is beyond what clocks do (300 ppm), or when the
/// events span less than ten seconds.
double clockRate(const std::vector<TimeMap::Knot>& events);

/// What a clock may be off, in parts per million of a duration.
inline constexpr double kClockPpm = 250;

}  // namespace rocinante
