#include "player/send/pacing.h"

#include <algorithm>

namespace rocinante {

Pacing::Step Pacing::step(SteadyTime now, SteadyTime deadline) const {
  if (now >= deadline) return {Action::send, deadline};
  const SteadyTime wake = deadline - spin();
  if (now >= wake) return {Action::spin, deadline};
  return {Action::sleep, std::min(wake, now + kLongestSleep)};
}

void Pacing::sent(SteadyTime deadline) {
  constexpr std::int64_t kWindow = 64;
  if (gaps_ >= 0) {
    const Nanoseconds gap = std::clamp(deadline - last_, Nanoseconds(0), kLongestGap);
    gaps_ = std::min(gaps_ + 1, kWindow);
    mean_gap_ += (gap - mean_gap_) / gaps_;
  } else {
    gaps_ = 0;
  }
  last_ = deadline;
}

void Pacing::woke(SteadyTime asked, SteadyTime now) {
  // Steps up and down in the ratio 199 to 1 settle where one sample in 200 is above.
  constexpr Nanoseconds kUp{15'920};
  constexpr Nanoseconds kDown{80};
  // Woken by a command, or a signal.
  if (now < asked) return;
  wakes_late_ += now - asked > wakes_late_ ? kUp : -kDown;
  wakes_late_ = std::clamp(wakes_late_, kLeastSpin, kMaxSpin);
}

}  // namespace rocinante
