#pragma once

#include <optional>
#include <utility>

#include "core/base/time.h"

namespace rocinante {

/// A place of the picture, in pixels from its top left.
using PicturePlace = std::pair<double, double>;

/// When what is under the mouse is looked for, for others: the scene is drawn for it, so not more
/// often than people notice, and where the mouse comes to rest in any case.
class PointerPace {
 public:
  static constexpr Nanoseconds kPeriod = std::chrono::milliseconds(100);

  /// Whether to look at `place` now; empty: the mouse is elsewhere.
  bool due(const std::optional<PicturePlace>& place, SteadyTime now) {
    if (place == looked_) return false;
    if (looked_at_ && now - *looked_at_ < kPeriod) return false;
    looked_ = place;
    looked_at_ = now;
    return true;
  }

 private:
  std::optional<PicturePlace> looked_;
  std::optional<SteadyTime> looked_at_;
};

}  // namespace rocinante
