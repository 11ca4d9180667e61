#include "core/clearance/enclosure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>

#include "core/clearance/triangle_tree.h"
#include "core/math/transform.h"

namespace rocinante {
namespace {

/// Of rays, one after another where one hits an edge: along no axis, and in no plane of two.
constexpr std::array<Vec3, 6> kRays = {
    Vec3{0.5773, 0.2137, 0.7881},   Vec3{-0.3119, 0.8941, 0.3217}, Vec3{0.7243, -0.6061, 0.3287},
    Vec3{-0.4561, -0.2713, 0.8477}, Vec3{0.1931, 0.4219, -0.8859}, Vec3{0.8839, 0.3371, -0.3243}};

/// Sets of corners, joined one by one.
class CornerSets {
 public:
  explicit CornerSets(std::size_t count) : above_(count) {
    std::iota(above_.begin(), above_.end(), std::uint32_t{0});
  }
  std::uint32_t find(std::uint32_t corner) {
    while (above_[corner] != corner) {
      above_[corner] = above_[above_[corner]];
      corner = above_[corner];
    }
    return corner;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t first = find(a), second = find(b);
    above_[std::max(first, second)] = std::min(first, second);
  }

 private:
  std::vector<std::uint32_t> above_;
};

/// By corner of each solid: the first corner that is at the same place.
std::vector<std::uint32_t> commonCorners(const std::vector<Solid>& solids) {
  const auto at = [&](std::uint32_t i) -> const Vec3& { return solids[i / 3].triangle[i % 3]; };
  std::vector<std::uint32_t> sorted(3 * solids.size());
  std::iota(sorted.begin(), sorted.end(), std::uint32_t{0});
  std::sort(sorted.begin(), sorted.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Vec3 &x = at(a), &y = at(b);
    if (x.x != y.x) return x.x < y.x;
    if (x.y != y.y) return x.y < y.y;
    if (x.z != y.z) return x.z < y.z;
    return a < b;
  });
  std::vector<std::uint32_t> common(sorted.size());
  std::uint32_t first = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (i == 0 || !(at(sorted[i]) == at(first))) first = sorted[i];
    common[sorted[i]] = first;
  }
  return common;
}

struct Edge {
  std::uint32_t low = 0, high = 0;
  std::int32_t way = 0;  ///< 1: from low to high
};

/// By solid: how often a ray from the origin goes out through it, less how often in; empty when the
/// ray meets an edge. The signs of neighbours agree to the bit, so that none slips between them.
std::optional<int> crossing(const Triangle& triangle, const Vec3& from, const Vec3& ray) {
  const Vec3 a = triangle[0] - from, b = triangle[1] - from, c = triangle[2] - from;
  const double at_c = dotOf(ray, crossOf(a, b)), at_a = dotOf(ray, crossOf(b, c));
  const double at_b = dotOf(ray, crossOf(c, a));
  const bool some_above = at_a > 0 || at_b > 0 || at_c > 0;
  const bool some_below = at_a < 0 || at_b < 0 || at_c < 0;
  if (some_above && some_below) return 0;
  if (a == b && b == c) return 0;
  if (at_a == 0 || at_b == 0 || at_c == 0) return std::nullopt;
  const double all = at_a + at_b + at_c;
  const double ahead =
      (at_a / all) * dotOf(a, ray) + (at_b / all) * dotOf(b, ray) + (at_c / all) * dotOf(c, ray);
  if (!(ahead > 0)) return 0;
  return some_above ? 1 : -1;
}

bool meets(const TriangleTree::Box& box, const Vec3& from, const Vec3& ray) {
  double enters = 0, leaves = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    // A little more than the box: rounding must not lose a triangle in its side.
    const double half = box.half[axis] * (1 + 1e-9) + 1e-9;
    const double middle = (box.centre[axis] - from[axis]) / ray[axis];
    const double reach = half / std::fabs(ray[axis]);
    enters = std::max(enters, middle - reach);
    leaves = std::min(leaves, middle + reach);
  }
  return enters <= leaves;
}

std::optional<int> windingAlong(const TriangleTree& tree, const Vec3& from, const Vec3& ray) {
  int winding = 0;
  std::array<std::uint32_t, 96> stack{};
  std::size_t depth = 1;
  while (depth > 0) {
    const TriangleTree::Node& node = tree.nodes()[stack[--depth]];
    if (!meets(node.box, from, ray)) continue;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (!tree.parts().is_closed[i]) continue;
      const std::optional<int> way = crossing(tree.solids()[i].triangle, from, ray);
      if (!way) return std::nullopt;
      winding += *way;
    }
    if (node.count > 0) continue;
    stack[depth++] = node.first;
    stack[depth++] = node.first + 1;
  }
  return winding;
}

bool isInBox(const TriangleTree::Box& box, const Vec3& point) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(std::fabs(point[axis] - box.centre[axis]) < box.half[axis])) return false;
  }
  return true;
}

/// The first point of the parts of `inner` that `outer` encloses, in its space.
std::optional<Vec3> pointInside(const TriangleTree& inner, const TriangleTree& outer,
                                const Mat4& inner_in_outer, double apart_m) {
  if (!outer.parts().any_closed) return std::nullopt;
  const TriangleTree::Box& box = outer.nodes()[0].box;
  // What is inside is no farther from the surface than the box is thick.
  if (apart_m > std::min({box.half.x, box.half.y, box.half.z})) return std::nullopt;
  const double reach = lengthOf(box.half) + inner.radius();
  if (lengthOf(transformPoint(inner_in_outer, inner.centre()) - box.centre) > reach) {
    return std::nullopt;
  }
  for (const Vec3& each : inner.parts().points) {
    const Vec3 point = transformPoint(inner_in_outer, each);
    if (isInBox(box, point) && encloses(outer, point)) return point;
  }
  return std::nullopt;
}

}  // namespace

SurfaceParts partsOf(const std::vector<Solid>& solids) {
  const std::vector<std::uint32_t> corner = commonCorners(solids);
  CornerSets sets(corner.size());
  std::vector<Edge> edges;
  edges.reserve(corner.size());
  for (std::size_t i = 0; i < corner.size(); i += 3) {
    for (std::size_t side = 0; side < 3; ++side) {
      const std::uint32_t a = corner[i + side], b = corner[i + (side + 1) % 3];
      if (a == b) continue;
      sets.join(a, b);
      edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& x, const Edge& y) {
    return x.low != y.low ? x.low < y.low : x.high < y.high;
  });
  std::vector<bool> is_open(corner.size(), false);  // by the part's first corner
  for (std::size_t i = 0; i < edges.size();) {
    const Edge first = edges[i];
    std::int64_t ways = 0;
    for (; i < edges.size() && edges[i].low == first.low && edges[i].high == first.high; ++i) {
      ways += edges[i].way;
    }
    if (ways != 0) is_open[sets.find(first.low)] = true;
  }
  SurfaceParts parts;
  parts.is_closed.resize(solids.size(), false);
  std::vector<bool> is_known(corner.size(), false);
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const std::uint32_t part = sets.find(corner[3 * i]);
    if (!is_known[part]) parts.points.push_back(solids[i].triangle[0]);
    is_known[part] = true;
    // What has a radius is measured as the solid it is.
    parts.is_closed[i] = !is_open[part] && solids[i].radius_m <= 0;
    parts.any_closed = parts.any_closed || parts.is_closed[i];
  }
  return parts;
}

bool encloses(const TriangleTree& tree, const Vec3& point) {
  if (tree.empty() || !tree.parts().any_closed) return false;
  for (const Vec3& ray : kRays) {
    if (const std::optional<int> winding = windingAlong(tree, point, ray)) return *winding != 0;
  }
  return false;
}

std::optional<Vec3> enclosedPoint(const TriangleTree& a, const TriangleTree& b, const Mat4& a_in_b,
                                  double apart_m) {
  if (const auto inside = pointInside(a, b, a_in_b, apart_m)) return inside;
  const auto inside = b.empty() || a.empty() || !a.parts().any_closed
                          ? std::nullopt
                          : pointInside(b, a, inverseOfRigid(a_in_b), apart_m);
  if (!inside) return std::nullopt;
  return transformPoint(a_in_b, *inside);
}

}  // namespace rocinante
