#pragma once

#include <optional>

#include "core/base/time.h"
#include "core/log/clock_message.h"

namespace rocinante {

/// One look at both clocks: the wall clock, read between two readings of the steady one.
struct ClockReading {
  SteadyTime before;
  WallTime wall;
  SteadyTime after;
};

/// The session's own steady time line: the wall time of the first look, plus the steady time since.
/// Whatever the wall clock does later bends nothing (docs/log-format.md, "Time and order"). Pure:
/// looks come from outside.
class SessionClock {
 public:
  explicit SessionClock(const ClockReading& first);

  /// Takes one more look. Answers with the step when the wall clock moved by more than 1 ms against
  /// the steady one since the look before; smaller moves are followed in silence. A look whose two
  /// steady readings lie too far apart to tell is passed over.
  std::optional<ClockStep> observe(const ClockReading& reading);

  /// The latest moment looked at.
  LogTime now() const { return now_; }
  LogTime at(SteadyTime moment) const;
  /// A kernel stamp (CLOCK_REALTIME) on the session's line; never after now(). A stamp from before
  /// the last step is told by where it falls.
  LogTime at(WallTime stamp) const;

 private:
  SteadyTime first_steady_;
  WallTime first_wall_;
  LogTime now_;
  LogTime looked_at_;                  ///< middle of the last good look
  Nanoseconds uncertainty_;            ///< of drift_
  Nanoseconds drift_{0};               ///< how far the wall clock has moved against the steady one
  Nanoseconds drift_before_{0};        ///< the same, before the last step
  std::optional<LogTime> step_after_;  ///< the last step came after this moment
};

}  // namespace rocinante
