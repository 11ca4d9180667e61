#pragma once

#include <array>

#include "core/math/vector.h"

namespace rocinante {

/// Three corners in metres. Two equal corners make a segment, three a point: both are valid.
using Triangle = std::array<Vec3, 3>;

/// Two nearest points, and how far apart they are.
struct NearestPoints {
  double distance_m = 0;
  Vec3 on_a{}, on_b{};
};

/// What is nearer than this touches: faces that lie on each other are apart by rounding alone.
inline constexpr double kTouching_m = 1e-9;

/// The distance between two triangles, 0 where they touch or cross, with a pair of nearest points.
/// In double from + - * / sqrt: the same bits on every processor. The rounding error is below
/// 1e-12 times the largest coordinate for triangles that are not slivers. Pure; any thread.
NearestPoints triangleDistance(const Triangle& a, const Triangle& b);

}  // namespace rocinante
