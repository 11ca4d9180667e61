#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/math/vector.h"
#include "core/mesh/mesh_builder.h"

namespace rocinante {

/// `corners` in the plane of the first `outer` of them, in which those run counter-clockwise.
void flattenPolygon(std::span<const glm::vec3> corners, std::size_t outer, std::vector<Vec2>& flat);

/// Cuts one polygon into triangles: a fan where it is convex, ear clipping where it is not. A
/// concave polygon of more than 2,048 corners is only fanned (ear clipping is quadratic).
class PolygonCutter {
 public:
  /// Three indices into `corners` per triangle, count - 2 triangles, wound like the polygon.
  /// Deterministic, also for polygons that cross themselves. At least 3 corners. Valid until the
  /// next call.
  std::span<const std::uint32_t> cut(std::span<const glm::vec3> corners);

  /// True when the last polygon was concave and too large for ear clipping.
  bool gaveUp() const { return gave_up_; }

 private:
  bool isEar(std::size_t corner) const;
  bool isStraight(std::size_t corner) const;
  void clipEars();

  std::vector<Vec2> flat_;  ///< in the polygon's plane, counter-clockwise
  std::vector<std::uint32_t> previous_, next_;
  std::vector<std::uint32_t> triangles_;
  bool gave_up_ = false;
};

/// Gives every corner without a normal the mean normal, weighted by angle, of the faces that share
/// its point (equal coordinates) and group and meet its face at `angle_deg` or less. The sums are
/// taken in file order with core/math's trigonometry, so they are the same on every CPU. A point in
/// more than 256 corners keeps its faces flat (the work is quadratic in their number).
void smoothNormals(LooseMesh& loose, double angle_deg);

/// The corners of a polygon with holes as one loop for PolygonCutter: bridges lead to each hole and
/// back. `corners` are those of the outline, then of each hole, either way round; `ends` is where
/// the outline and each hole end. Cubic in their number at worst.
std::vector<std::uint32_t> loopAroundHoles(std::span<const glm::vec3> corners,
                                           std::span<const std::size_t> ends);

}  // namespace rocinante
