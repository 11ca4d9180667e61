#include "player/pacing.h"

#include <algorithm>

namespace rocinante {

Pacing::Step Pacing::step(SteadyTime now, SteadyTime deadline) const {
  if (now >= deadline) return {Action::send, deadline};
  const SteadyTime wake = deadline - spin();
  if (now >= wake) return {Action::spin, deadline};
  return {Action::sleep, std::min(wake, now + kLongestSleep)};
}

void Pacing::sent(SteadyTime deadline) {
  // A pause says nothing about the rate around it; unbounded, it would hide the next burst.
  constexpr Nanoseconds kLongestGap = std::chrono::milliseconds(10);
  constexpr int kWindow = 64;
  if (any_) {
    const Nanoseconds gap = std::clamp(deadline - last_, Nanoseconds(0), kLongestGap);
    mean_gap_ += (gap - mean_gap_) / kWindow;
  }
  any_ = true;
  last_ = deadline;
}

}  // namespace rocinante
