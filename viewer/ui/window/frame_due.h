#pragma once

#include <algorithm>

#include "core/base/time.h"

namespace rocinante {

/// Decides when a window at rest draws a frame: some at once after anything happened, some more
/// while panels still answer it, then at the pace at which panels change by themselves. Reads no
/// clock.
class FrameDue {
 public:
  /// A press shows in its frame, its effect on panels in the next one, and auto-sized panels need
  /// one more.
  static constexpr int kSettlingFrames = 3;
  /// Hints appear a while after the mouse came to rest.
  static constexpr Nanoseconds kAnswering{1'000'000'000};
  static constexpr Nanoseconds kAnswerEvery{100'000'000};

  void happened(SteadyTime now) {
    settling_ = kSettlingFrames;
    happened_at_ = now;
  }
  /// Something new is to be shown, which nothing has to answer.
  void drawSoon() { settling_ = std::max(settling_, 1); }
  void drawn(SteadyTime now) {
    if (settling_ > 0) --settling_;
    drawn_at_ = now;
  }
  /// `panels_every`: how often panels change by themselves; Nanoseconds::max(): never.
  bool at(SteadyTime now, Nanoseconds panels_every) const {
    if (settling_ > 0) return true;
    const Nanoseconds since = now - drawn_at_;
    if (now - happened_at_ < kAnswering && since >= kAnswerEvery) return true;
    return since >= panels_every;
  }

 private:
  int settling_ = kSettlingFrames;
  SteadyTime happened_at_{}, drawn_at_{};
};

}  // namespace rocinante
