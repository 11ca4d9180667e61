#include "core/clearance/triangle_tree.h"

#include <algorithm>
#include <utility>

#include "core/mesh/mesh.h"

namespace rocinante {
namespace {

constexpr std::uint32_t kLeafSolids = 2;

void addSolid(Bounds& bounds, const Solid& solid) {
  const Vec3 around(solid.radius_m);
  for (const Vec3& corner : solid.triangle) {
    bounds.add(corner - around);
    bounds.add(corner + around);
  }
}

}  // namespace

TriangleTree::TriangleTree(std::vector<Solid> solids) : solids_(std::move(solids)) {
  if (solids_.empty()) return;
  nodes_.reserve(2 * solids_.size());
  nodes_.emplace_back();
  build(0, 0, static_cast<std::uint32_t>(solids_.size()));
  parts_ = partsOf(solids_);
  centre_ = nodes_[0].box.centre;
  for (const Solid& solid : solids_) {
    for (const Vec3& corner : solid.triangle) {
      radius_m_ = std::max(radius_m_, lengthOf(corner - centre_) + solid.radius_m);
    }
  }
}

void TriangleTree::build(std::uint32_t node, std::uint32_t first, std::uint32_t count) {
  Bounds bounds, middles;
  const auto middle = [](const Solid& solid) {
    return solid.triangle[0] + solid.triangle[1] + solid.triangle[2];
  };
  for (std::uint32_t i = first; i < first + count; ++i) {
    addSolid(bounds, solids_[i]);
    middles.add(middle(solids_[i]));
  }
  nodes_[node].box = {(bounds.min + bounds.max) * 0.5, (bounds.max - bounds.min) * 0.5};
  nodes_[node].under = count;
  if (count <= kLeafSolids) {
    nodes_[node].first = first;
    nodes_[node].count = count;
    return;
  }
  const Vec3 extent = middles.max - middles.min;
  int axis = extent.y > extent.x ? 1 : 0;
  if (extent.z > extent[axis]) axis = 2;
  const auto begin = solids_.begin() + static_cast<std::ptrdiff_t>(first);
  const std::uint32_t half = count / 2;
  // Stable, so that equal middles stay in the mesh's order with every standard library.
  std::stable_sort(
      begin, begin + static_cast<std::ptrdiff_t>(count),
      [&](const Solid& a, const Solid& b) { return middle(a)[axis] < middle(b)[axis]; });
  const auto children = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].first = children;
  nodes_.resize(nodes_.size() + 2);
  build(children, first, half);
  build(children + 1, first + half, count - half);
}

}  // namespace rocinante
