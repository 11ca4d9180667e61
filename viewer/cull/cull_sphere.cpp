#include "viewer/cull/cull_sphere.h"

#include <algorithm>
#include <cmath>

namespace rocinante {
namespace {

/// Far above the rounding errors in double, far below any visible size.
constexpr double kSlack = 1e-9;

double sizeOf(const Vec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

}  // namespace

double scaleBound(const Mat4& m) {
  const Vec3 x(m[0]);
  const Vec3 y(m[1]);
  const Vec3 z(m[2]);
  return std::sqrt(dotOf(x, x) + dotOf(y, y) + dotOf(z, z));
}

CullSphere linkSphere(const PosedDevice& device, std::size_t link, double reach) {
  const Mat4& world = device.link_world[link];
  return {Vec3(world[3]), reach * scaleBound(world)};
}

CullSphere deviceSphere(const PosedDevice& device, const LinkReaches& reaches) {
  Vec3 min(1e300), max(-1e300);
  for (std::size_t link = 0; link < reaches.size(); ++link) {
    if (reaches[link] < 0) continue;
    const Vec3 at(device.link_world[link][3]);
    // A value that is not finite makes the sphere infinite.
    if (!std::isfinite(sizeOf(at))) return {Vec3(0), HUGE_VAL};
    min = glm::min(min, at);
    max = glm::max(max, at);
  }
  CullSphere all{(min + max) * 0.5, 0};
  for (std::size_t link = 0; link < reaches.size(); ++link) {
    if (reaches[link] < 0) continue;
    const CullSphere one = linkSphere(device, link, reaches[link]);
    const double radius = lengthOf(one.center - all.center) + one.radius_m;
    if (!std::isfinite(radius)) return {Vec3(0), HUGE_VAL};
    all.radius_m = std::max(all.radius_m, radius);
  }
  return all;
}

bool mayBeSeen(const Camera& camera, const CullSphere& sphere) {
  const double size = sizeOf(sphere.center) + sizeOf(camera.eye()) + sphere.radius_m;
  if (!std::isfinite(size)) return true;
  return camera.sees(sphere.center, sphere.radius_m + kSlack * size);
}

}  // namespace rocinante
