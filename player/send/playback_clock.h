#pragma once

#include "core/base/playback_speed.h"
#include "core/base/time.h"

namespace rocinante {

/// Computes when each moment of a session is due. Pure arithmetic: it neither sleeps nor reads a
/// clock, so a test can play an hour in a microsecond.
///
/// Every deadline is measured from one anchor and never from the previous deadline, so rounding
/// does not add up over a long log.
class PlaybackClock {
 public:
  /// `log_anchor` is due at `real_anchor`.
  PlaybackClock(LogTime log_anchor, SteadyTime real_anchor, PlaybackSpeed speed)
      : log_anchor_(log_anchor), real_anchor_(real_anchor), speed_(speed) {}

  /// Never decreases as `moment` grows.
  SteadyTime deadline(LogTime moment) const {
    return real_anchor_ + speed_.realDuration(moment - log_anchor_);
  }

  /// The moment due at `now`: the inverse of deadline(), within a nanosecond of log or real time.
  LogTime moment(SteadyTime now) const {
    return log_anchor_ + speed_.logDuration(now - real_anchor_);
  }

 private:
  LogTime log_anchor_;
  SteadyTime real_anchor_;
  PlaybackSpeed speed_;
};

}  // namespace rocinante
