#pragma once

#include <cstdint>
#include <limits>

#include "core/clearance/aimed_tree.h"
#include "core/clearance/triangle_tree.h"
#include "core/math/vector.h"

namespace rocinante {

/// The nearest points of two trees.
struct TreeContact {
  double distance_m = std::numeric_limits<double>::infinity();
  Vec3 on_a{}, on_b{};  ///< in the space of b
  std::uint32_t solid_a = 0, solid_b = 0;
  bool at_end = false;  ///< of a sweep: found at its end, not its start
};

/// The distance between two trees, a placed in b's space by `a_in_b`; 0 where surfaces touch or
/// cross, and where a part of one lies inside the other (encloses()). `known`: where the nearest
/// solids were last, which makes the search faster and the answer no other. Infinite when a tree is
/// empty.
TreeContact treeDistance(const TriangleTree& a, const TriangleTree& b, const Mat4& a_in_b,
                         const TreeContact* known = nullptr);

/// What of a distance matters to the one who asks.
struct DistanceNeed {
  double near_m = 0;         ///< whether it is below this
  double exact_below_m = 0;  ///< its value, if it is below this
};
struct BoundedDistance {
  TreeContact contact;  ///< two points this far apart; the nearest if below exact_below_m
  /// The distance is not smaller; equal to the contact's where that is exact.
  double at_least_m = 0;
};

/// How far b begins behind the end of a along a direction of unit length in b's space: their
/// distance is not smaller. Of bodies that are not hollowed towards each other it is the distance
/// itself along the line between their nearest points. Far cheaper than that is to find.
double gapAlong(const Vec3& direction, const TriangleTree& a, const TriangleTree& b,
                const Mat4& a_in_b);

/// A motion of a in b's space that no point of a leaves by more than `bulge_m`: every point goes
/// from its place by `from` to its place by `to`, and is at any share of the time within the bulge
/// of the same share of the straight line.
struct TreeSweep {
  Mat4 from{1.0}, to{1.0};
  double bulge_m = 0;
};

/// Searches pairs of trees. Keeps only room to work in between two searches: an answer depends on
/// its arguments alone. One thread.
class TreeSearch {
 public:
  /// treeDistance() that stops as soon as what is needed is known. A distance that is not needed is
  /// known to within half of it, or to be above all that is.
  BoundedDistance bounded(const TriangleTree& a, const TriangleTree& b, const Mat4& a_in_b,
                          const DistanceNeed& need, const TreeContact* known = nullptr);

  /// Looks for distances below `cut_m` during a sweep. `least` is improved by the distances at both
  /// ends of it, of those triangles that may matter; its solids are looked at first. Returns
  /// whether there may be a distance between that is below `cut_m` and more than `tolerance_m`
  /// below `least`: then split the sweep, and ask for each part.
  bool sweep(const TriangleTree& a, const TriangleTree& b, const TreeSweep& sweep, double cut_m,
             double tolerance_m, TreeContact& least);

 private:
  class Direction;

  AimedTree a_, b_;
};

/// At most this far any point within `radius_m` of `centre` moves between two rigid placements.
double displacement(const Mat4& from, const Mat4& to, const Vec3& centre, double radius_m);

}  // namespace rocinante
