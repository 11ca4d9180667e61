#pragma once

#include <optional>

#include "core/base/time.h"
#include "core/log/clock_message.h"

namespace rocinante {

/// One reading of both clocks: the wall clock, read between two readings of the steady one.
struct ClockReading {
  SteadyTime before;
  WallTime wall;
  SteadyTime after;
};

/// The clocks, read at almost one moment: the narrowest of a few readings.
ClockReading readClocks();

/// The session's own steady time line: the wall time of the first reading, plus the steady time
/// since. Later changes of the wall clock do not affect it (docs/log-format.md, "Time and order").
/// Readings come from outside.
class SessionClock {
 public:
  explicit SessionClock(const ClockReading& first);

  /// Takes one more reading. Returns the step when the wall clock moved by more than 1 ms against
  /// the steady one since the last reading; smaller moves are followed silently. A reading whose
  /// two steady times are too far apart is ignored.
  std::optional<ClockStep> observe(const ClockReading& reading);

  /// The time of the latest reading.
  LogTime now() const { return now_; }
  LogTime at(SteadyTime moment) const;
  /// A kernel timestamp (CLOCK_REALTIME) on the session's time line; never after now(). A timestamp
  /// from before the last step is recognised by its value.
  LogTime at(WallTime stamp) const;

 private:
  SteadyTime first_steady_;
  WallTime first_wall_;
  LogTime now_;
  LogTime looked_at_;                  ///< middle of the last good reading
  Nanoseconds uncertainty_;            ///< of drift_
  Nanoseconds drift_{0};               ///< how far the wall clock has moved against the steady one
  Nanoseconds drift_before_{0};        ///< the same, before the last step
  std::optional<LogTime> step_after_;  ///< the last step came after this moment
};

}  // namespace rocinante
