#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/clearance/triangle_tree.h"
#include "core/math/vector.h"

namespace rocinante {

/// Three directions of unit length at right angles: one that is given, and two across it.
using Aim = std::array<Vec3, 3>;
Aim aimAlong(const Vec3& unit_direction);

/// From where to where something reaches along the three directions of an aim.
struct Extent {
  std::array<double, 3> low{}, high{};

  void add(const Extent& other) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], other.low[i]);
      high[i] = std::max(high[i], other.high[i]);
    }
  }
};

/// What lies between two extents: their contents are not nearer than its root.
inline double squaredGap(const Extent& a, const Extent& b) {
  double squared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double ahead = b.low[i] - a.high[i], behind = a.low[i] - b.high[i];
    const double gap = ahead > behind ? ahead : behind;
    squared += gap > 0 ? gap * gap : 0;
  }
  return squared;
}

/// The extents of a tree's nodes and solids along an aim, each computed when first asked for: a
/// search asks for each many times. They are bounds, rounding included. Along the line between two
/// surfaces' nearest points a node of a flat part is as thin as the part; its box in the link's
/// space seldom is. Memory: 56 bytes for each node and solid of the largest tree it was of. One
/// thread.
class AimedTree {
 public:
  /// Begins with a tree, which must outlive what is asked of it.
  void begin(const TriangleTree& tree);
  /// In one place, or in two and on the straight ways between; and `more_m` around it.
  void aim(const Aim& aim, std::span<const Mat4> places, double more_m);

  const Extent& ofNode(std::uint32_t i) {
    Known& known = nodes_[i];
    if (known.stamp != stamp_) fillNode(i, known);
    return known.extent;
  }
  const Extent& ofSolid(std::uint32_t i) {
    Known& known = solids_[i];
    if (known.stamp != stamp_) fill(tree_->solids()[i], known);
    return known.extent;
  }

 private:
  struct Known {
    Extent extent;
    std::uint64_t stamp = 0;
  };
  /// A place seen along the aim.
  struct Place {
    std::array<Vec3, 3> rows{};
    std::array<double, 3> offset{};
  };

  void fillNode(std::uint32_t i, Known& known);
  void fill(const TriangleTree::Box& box, Known& known) const;
  void fill(const Solid& solid, Known& known) const;

  const TriangleTree* tree_ = nullptr;
  std::array<Place, 2> places_{};
  std::size_t count_ = 0;
  double more_m_ = 0;
  std::uint64_t stamp_ = 0;
  std::vector<Known> nodes_, solids_;
};

}  // namespace rocinante
