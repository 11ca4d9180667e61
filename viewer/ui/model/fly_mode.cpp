#include "viewer/ui/model/fly_mode.h"

#include <algorithm>
#include <cmath>

namespace rocinante {

void FlyMode::setSceneSize(double metres) {
  scene_m_ = std::isfinite(metres) && metres > 0 ? std::clamp(metres, 0.01, 1e6) : 1;
}

void FlyMode::changeSpeed(double steps) {
  constexpr double kStep = 1.25;
  constexpr double kMost = 1000;
  if (!std::isfinite(steps)) return;
  // Whole steps one by one and the rest in proportion: the last bits of pow() differ by CPU.
  double left = std::clamp(std::abs(steps), 0.0, 50.0);
  double factor = 1;
  for (; left >= 1; left -= 1) factor *= kStep;
  factor *= 1 + (kStep - 1) * left;
  factor_ = std::clamp(steps > 0 ? factor_ * factor : factor_ / factor, 1 / kMost, kMost);
}

Vec3 FlyMode::step(const FlyKeys& keys, SteadyTime now) {
  if (!keys.any()) {
    last_.reset();
    return {0, 0, 0};
  }
  active_ = true;
  const Nanoseconds took =
      last_ ? std::clamp(now - *last_, Nanoseconds(0), kLongestStep) : kFirstStep;
  last_ = now;
  const auto along = [](bool more, bool less) { return static_cast<double>(more) - less; };
  const Vec3 way(along(keys.right, keys.left), along(keys.forward, keys.back),
                 along(keys.up, keys.down));
  const double length = lengthOf(way);
  if (length == 0) return way;
  const double metres =
      speed() * (keys.faster ? kFaster : 1) * static_cast<double>(took.count()) * 1e-9;
  return way * (metres / length);
}

void FlyMode::end() {
  active_ = false;
  last_.reset();
}

}  // namespace rocinante
