#pragma once

#include <optional>
#include <vector>

#include "core/clearance/triangle_distance.h"
#include "core/math/vector.h"

namespace rocinante {

struct Solid;
class TriangleTree;

/// The parts of a surface: what hangs together by common corners (equal to the bit). A part is
/// closed when each edge of its triangles is passed as often one way as the other, as in a solid
/// whose triangles all face outwards. Immutable; any thread.
struct SurfaceParts {
  std::vector<Vec3> points;     ///< a corner of each part
  std::vector<bool> is_closed;  ///< by solid: its part is
  bool any_closed = false;
};
SurfaceParts partsOf(const std::vector<Solid>& solids);

/// Whether the closed parts of a surface go around the point. Two shells one in the other, as of a
/// tank with walls, leave a hollow, which is outside. The point must not lie on the surface.
bool encloses(const TriangleTree& tree, const Vec3& point);

/// A point of the part of one body that lies inside the other, in b's space. The surfaces must not
/// touch, and are at least `apart_m` from each other.
std::optional<Vec3> enclosedPoint(const TriangleTree& a, const TriangleTree& b, const Mat4& a_in_b,
                                  double apart_m);

}  // namespace rocinante
