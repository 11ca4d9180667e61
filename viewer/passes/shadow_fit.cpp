#include "viewer/passes/shadow_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/transform.h"

namespace rocinante {
namespace {

constexpr double kFarthest = 1e7;

bool isUsable(const Vec3& a) {
  // False for NaN.
  return std::abs(a.x) <= kFarthest && std::abs(a.y) <= kFarthest && std::abs(a.z) <= kFarthest;
}

/// Rounds up to 1, 1.25, 1.5 or 1.75 times a power of two.
double steppedUp(double size) {
  double power = 1.0 / 1024;
  while (power * 2 <= size) power *= 2;
  for (const double step : {1.0, 1.25, 1.5, 1.75}) {
    if (power * step >= size) return power * step;
  }
  return power * 2;
}

}  // namespace

ShadowFit shadowFit(const std::vector<Vec3>& corners, const Vec3& towards_light, int map_side) {
  const double length = lengthOf(towards_light);
  const bool has_direction = length > 0 && std::isfinite(length);
  const Vec3 forward = has_direction ? -towards_light / length : Vec3(0, 0, -1);
  // As in Camera for this view.
  const Vec3 up_hint = std::abs(forward.z) < 0.99 ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
  Vec3 right = crossOf(forward, up_hint);
  right /= lengthOf(right);
  const Vec3 up = crossOf(right, forward);

  Vec3 low(1e300, 1e300, 1e300);
  Vec3 high(-1e300, -1e300, -1e300);
  for (const Vec3& corner : corners) {
    if (!isUsable(corner)) continue;
    const Vec3 place(dotOf(corner, right), dotOf(corner, up), dotOf(corner, forward));
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], place[i]);
      high[i] = std::max(high[i], place[i]);
    }
  }
  if (low.x > high.x) low = high = Vec3(0, 0, 0);

  ShadowFit fit;
  // Room for the filter at the border, and for half a texel of snapping on each side.
  const double room = 1 - 8.0 / map_side;
  const double half = steppedUp(std::max(high.x - low.x, high.y - low.y) / 2 / room);
  fit.texel_m = 2 * half / map_side;
  const auto snapped = [&](double place) {
    return std::floor(place / fit.texel_m + 0.5) * fit.texel_m;
  };
  // The depth range only needs to be as stable as the size.
  fit.reach_m = steppedUp((high.z - low.z) / 2 + half);
  const double depth_step = fit.reach_m / 16;
  fit.reach_m += depth_step;
  const double depth = std::floor((low.z + high.z) / 2 / depth_step + 0.5) * depth_step;
  fit.view.eye =
      right * snapped((low.x + high.x) / 2) + up * snapped((low.y + high.y) / 2) + forward * depth;
  fit.view.target = fit.view.eye + forward;
  fit.view.up = up_hint;
  fit.view.ortho_height_m = 2 * half;
  return fit;
}

}  // namespace rocinante
