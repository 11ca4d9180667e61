#pragma once

#include <algorithm>
#include <cstdint>

#include "core/time.h"

namespace rocinante {

/// Decides how to wait for a deadline: a timer wakes some microseconds late, so the last stretch is
/// spun. Pure: it sees the clock only through its arguments.
///
/// A thread that spins most of the time is throttled by the kernel (a real-time one for 50 ms of
/// each second) and burns a core, so spinning takes less than half of the time: the closer the
/// deadlines lie, the shorter the last stretch. Above 16,000 a second the calls alone fill much of
/// the time, and it only sleeps. What is due together is sent together.
class Pacing {
 public:
  /// A timer under SCHED_FIFO wakes within this (measured: p99 29 us, longest usually below 60).
  static constexpr Nanoseconds kSpin{60'000};
  /// Closer deadlines are not spun for (measured: at 60,000/s it made the kernel throttle).
  static constexpr Nanoseconds kLeastGap{60'000};
  /// No sleep is longer, so that a stop or a progress line never waits.
  static constexpr Nanoseconds kLongestSleep{100'000'000};

  enum class Action : std::uint8_t { send, spin, sleep };
  struct Step {
    Action action;
    SteadyTime until;  ///< sleep: wake at this moment; at or before the deadline
  };

  /// What to do at `now` about something due at `deadline`.
  Step step(SteadyTime now, SteadyTime deadline) const;

  /// Says that what was due at `deadline` was sent: learns how far deadlines lie apart.
  void sent(SteadyTime deadline);

  /// The last stretch before a deadline, by the deadlines so far.
  Nanoseconds spin() const {
    return mean_gap_ < kLeastGap ? Nanoseconds(0) : std::min(kSpin, mean_gap_ * 9 / 20);
  }

 private:
  bool any_ = false;
  SteadyTime last_{};
  Nanoseconds mean_gap_{std::chrono::milliseconds(10)};
};

}  // namespace rocinante
