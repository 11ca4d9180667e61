#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/clearance/enclosure.h"
#include "core/clearance/triangle_distance.h"
#include "core/math/vector.h"

namespace rocinante {

/// A triangle, or with a radius everything within `radius_m` of it: a sphere is a point with a
/// radius, a capsule a segment with one, both exact.
struct Solid {
  Triangle triangle{};
  double radius_m = 0;
};

/// The surface of one link in the link's space, as a tree of boxes. Immutable; any thread. Built
/// from the same solids it is the same on every processor.
class TriangleTree {
 public:
  explicit TriangleTree(std::vector<Solid> solids);

  bool empty() const { return solids_.empty(); }
  std::size_t size() const { return solids_.size(); }
  /// All solids are within this of `centre()`.
  double radius() const { return radius_m_; }
  const Vec3& centre() const { return centre_; }

  struct Box {
    Vec3 centre{}, half{};  ///< half of each side
  };
  struct Node {
    Box box;
    std::uint32_t first =
        0;  ///< a leaf's first solid; else the left child, the right one behind it
    std::uint32_t count = 0;  ///< solids of a leaf; 0: not a leaf
    std::uint32_t under = 0;  ///< solids of all leaves below
  };
  /// The root comes first; none when empty.
  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<Solid>& solids() const { return solids_; }
  /// In the order of solids().
  const SurfaceParts& parts() const { return parts_; }

 private:
  void build(std::uint32_t node, std::uint32_t first, std::uint32_t count);

  std::vector<Solid> solids_;
  std::vector<Node> nodes_;
  SurfaceParts parts_;
  Vec3 centre_{};
  double radius_m_ = 0;
};

}  // namespace rocinante
