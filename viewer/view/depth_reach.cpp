#include "viewer/view/depth_reach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace rocinante {
namespace {

/// Clips a polygon to sign * p[axis] <= most.
std::vector<Vec3> cutOff(const std::vector<Vec3>& polygon, int axis, double sign, double most) {
  std::vector<Vec3> inside;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3& from = polygon[i];
    const Vec3& to = polygon[(i + 1) % polygon.size()];
    const double before = most - sign * from[axis];
    const double after = most - sign * to[axis];
    if (before >= 0) inside.push_back(from);
    if ((before > 0 && after < 0) || (before < 0 && after > 0)) {
      inside.push_back(from + (to - from) * (before / (before - after)));
    }
  }
  return inside;
}

/// Largest depth of the visible part of a box in camera axes (right, up, along the view).
double seenReach(const std::array<Vec3, 8>& box, double half_width, double half_height) {
  double farthest = 0;
  for (unsigned axis = 0; axis < 3; ++axis) {
    const unsigned one = 1U << (axis + 1) % 3;
    const unsigned other = 1U << (axis + 2) % 3;
    for (const unsigned side : {0U, 1U << axis}) {
      std::vector<Vec3> face{box[side], box[side | one], box[side | one | other],
                             box[side | other]};
      for (const double sign : {-1.0, 1.0}) {
        face = cutOff(cutOff(face, 0, sign, half_width), 1, sign, half_height);
      }
      for (const Vec3& corner : face) farthest = std::max(farthest, std::abs(corner.z));
    }
  }
  return farthest;
}

double powerOfTwo(double least) {
  double reach = 1;
  while (reach < least && reach < 1e12) reach *= 2;
  return reach;
}

}  // namespace

double depthReach(const Camera& camera, std::span<const Vec3> corners, double grid_m) {
  constexpr double kFine_m = 128;
  double whole = std::max(grid_m, lengthOf(camera.eye()) + grid_m * 1.5);
  for (const Vec3& corner : corners) whole = std::max(whole, lengthOf(corner - camera.eye()));
  if (whole <= kFine_m) return powerOfTwo(whole);

  constexpr double kMargin = 1.01;
  const double half_height = camera.metersPerPixel(0) * camera.height() / 2 * kMargin;
  const double half_width = camera.metersPerPixel(0) * camera.width() / 2 * kMargin;
  double farthest = 0;
  for (std::size_t first = 0; first + 8 <= corners.size(); first += 8) {
    std::array<Vec3, 8> box;
    double depth = 0;
    for (std::size_t k = 0; k < 8; ++k) {
      const Vec3 offset = corners[first + k] - camera.eye();
      box[k] = {dotOf(offset, camera.right()), dotOf(offset, camera.up()),
                dotOf(offset, camera.forward())};
      depth = std::max(depth, std::abs(box[k].z));
    }
    if (depth > farthest) farthest = std::max(farthest, seenReach(box, half_width, half_height));
  }
  return powerOfTwo(farthest * kMargin);
}

}  // namespace rocinante
