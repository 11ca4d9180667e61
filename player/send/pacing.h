#pragma once

#include <algorithm>
#include <cstdint>

#include "core/base/time.h"

namespace rocinante {

/// Decides how to wait for a deadline: a timer wakes some microseconds late, so the last stretch is
/// spent spinning. Pure: it sees the clock only through its arguments.
///
/// How late a timer wakes depends on the machine (measured: 10 us on a busy one, 100 us on an idle
/// one, whose processor has to wake up too), so the last stretch is as long as was needed in 199 of
/// 200 cases so far. A thread that spins most of the time is throttled by the kernel (a real-time
/// one for 50 ms of each second) and burns a core, so spinning takes little more than a third of
/// the time: the closer the deadlines, the shorter the last stretch. Above 16,000 a second the
/// calls alone fill much of the time, and it only sleeps. Datagrams due together are sent together.
class Pacing {
 public:
  /// The longest stretch, and at low rates the shortest.
  static constexpr Nanoseconds kMaxSpin{300'000};
  static constexpr Nanoseconds kLeastSpin{40'000};
  /// The stretch before anything was learnt.
  static constexpr Nanoseconds kFirstSpin{120'000};
  /// No spinning for closer deadlines (measured: at 60,000/s it made the kernel throttle).
  static constexpr Nanoseconds kLeastGap{60'000};
  /// The longest sleep, so that a stop or a progress line does not wait.
  static constexpr Nanoseconds kLongestSleep{100'000'000};

  enum class Action : std::uint8_t { send, spin, sleep };
  struct Step {
    Action action;
    SteadyTime until;  ///< sleep: wake at this moment; at or before the deadline
  };

  /// How to wait at `now` for something due at `deadline`.
  Step step(SteadyTime now, SteadyTime deadline) const;

  /// Call after sending what was due at `deadline`: learns the distance of deadlines.
  void sent(SteadyTime deadline);
  /// Call when a sleep until `asked` ended at `now`: learns how late timers wake.
  void woke(SteadyTime asked, SteadyTime now);

  /// The current length of the last stretch before a deadline.
  Nanoseconds spin() const {
    return mean_gap_ < kLeastGap ? Nanoseconds(0) : std::min(wakes_late_, mean_gap_ * 9 / 25);
  }

 private:
  // A pause says nothing about the rate around it; unbounded, it would hide the next burst.
  static constexpr Nanoseconds kLongestGap{1'000'000};

  std::int64_t gaps_ = -1;
  SteadyTime last_{};
  Nanoseconds mean_gap_ = kLongestGap;
  Nanoseconds wakes_late_ = kFirstSpin;
};

}  // namespace rocinante
