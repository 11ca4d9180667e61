#include "core/clearance/triangle_tree.h"

#include <algorithm>
#include <array>

#include "core/math/transform.h"
#include "core/mesh/mesh.h"

namespace rocinante {
namespace {

constexpr std::uint32_t kLeafSolids = 2;
/// More than that of a bound: what is as near as another to the last bit is not left out.
constexpr double kRounding_m = 1e-12;

void addSolid(Bounds& bounds, const Solid& solid) {
  const Vec3 around(solid.radius_m);
  for (const Vec3& corner : solid.triangle) {
    bounds.add(corner - around);
    bounds.add(corner + around);
  }
}

/// `local` seen from another space: the box around it there.
TriangleTree::Box boxIn(const Mat4& placed, const TriangleTree::Box& local) {
  TriangleTree::Box box;
  box.centre = transformPoint(placed, local.centre);
  for (int i = 0; i < 3; ++i) {
    box.half[i] = std::fabs(placed[0][i]) * local.half.x + std::fabs(placed[1][i]) * local.half.y +
                  std::fabs(placed[2][i]) * local.half.z;
  }
  return box;
}

double squaredGap(const TriangleTree::Box& a, const TriangleTree::Box& b) {
  double squared = 0;
  for (int i = 0; i < 3; ++i) {
    const double gap = std::fabs(a.centre[i] - b.centre[i]) - a.half[i] - b.half[i];
    if (gap > 0) squared += gap * gap;
  }
  return squared;
}

/// The box around two, and `more` on every side.
TriangleTree::Box hullOf(const TriangleTree::Box& a, const TriangleTree::Box& b, double more) {
  TriangleTree::Box hull;
  for (int i = 0; i < 3; ++i) {
    const double low = std::min(a.centre[i] - a.half[i], b.centre[i] - b.half[i]) - more;
    const double high = std::max(a.centre[i] + a.half[i], b.centre[i] + b.half[i]) + more;
    hull.centre[i] = (low + high) / 2;
    hull.half[i] = (high - low) / 2;
  }
  return hull;
}

double extentOf(const TriangleTree::Box& box) { return box.half.x + box.half.y + box.half.z; }

Triangle placed(const Mat4& placement, const Triangle& local) {
  return {transformPoint(placement, local[0]), transformPoint(placement, local[1]),
          transformPoint(placement, local[2])};
}

/// The distance between two solids, from that of their triangles.
NearestPoints solidDistance(const Solid& a, const Triangle& at, const Solid& b) {
  NearestPoints nearest = triangleDistance(at, b.triangle);
  const double both = a.radius_m + b.radius_m;
  if (both <= 0 || !(nearest.distance_m > 0)) return nearest;
  const Vec3 direction = (nearest.on_b - nearest.on_a) * (1 / nearest.distance_m);
  if (nearest.distance_m < both + kTouching_m) {
    const Vec3 between = nearest.on_a + direction * std::min(a.radius_m, nearest.distance_m);
    return {0, between, between};
  }
  return {nearest.distance_m - both, nearest.on_a + direction * a.radius_m,
          nearest.on_b - direction * b.radius_m};
}

void take(const NearestPoints& nearest, std::uint32_t solid_a, std::uint32_t solid_b, bool at_end,
          TreeContact& least) {
  if (!(nearest.distance_m < least.distance_m)) return;
  least = {nearest.distance_m, nearest.on_a, nearest.on_b, solid_a, solid_b, at_end};
}

/// How far b's solid lies from a's along a direction of unit length: negative where they overlap
/// in it. A bound from below of their distance, whatever the direction.
double gapAlong(const Vec3& direction, const Triangle& a, const Triangle& b) {
  const auto along = [&](const Vec3& point) { return dotOf(direction, point); };
  const double a_end = std::max({along(a[0]), along(a[1]), along(a[2])});
  const double b_start = std::min({along(b[0]), along(b[1]), along(b[2])});
  return b_start - a_end;
}

/// The direction between the nearest points so far: along it whole nodes lie beyond one another
/// that are as near in space as the steps or the boxes are coarse.
class BestDirection {
 public:
  void follow(const TreeContact& least) {
    if (least.distance_m == followed_m_) return;
    followed_m_ = least.distance_m;
    const Vec3 between = least.on_b - least.on_a;
    const double length = lengthOf(between);
    is_known_ = length > 0 && std::isfinite(least.distance_m);
    if (is_known_) along_ = between * (1 / length);
  }

  /// How far box b begins behind the end of box a.
  double gap(const TriangleTree::Box& a, const TriangleTree::Box& b) const {
    const auto reach = [&](const TriangleTree::Box& box) {
      return std::fabs(along_.x) * box.half.x + std::fabs(along_.y) * box.half.y +
             std::fabs(along_.z) * box.half.z;
    };
    return dotOf(along_, b.centre - a.centre) - reach(a) - reach(b);
  }
  double gap(const Triangle& a, const Triangle& b) const {
    return is_known_ ? gapAlong(along_, a, b) : -std::numeric_limits<double>::infinity();
  }
  double squared(double gap) const { return is_known_ && gap > 0 ? gap * gap : 0; }

 private:
  double followed_m_ = -1;
  bool is_known_ = false;
  Vec3 along_{};
};

/// Visits pairs of nodes, nearer ones first. `distance(node_a, node_b)` squared; `limit()`: pairs
/// farther than it do not matter, and it may shrink; `leaves(node_a, node_b)`.
template <class Distance, class Limit, class Leaves>
void visitPairs(const TriangleTree& a, const TriangleTree& b, const Distance& distance,
                const Limit& limit, const Leaves& leaves) {
  struct Pair {
    std::uint32_t a, b;
    double squared;
  };
  // Each step takes one pair and adds two; trees are balanced, so this is deep enough for 2^32.
  std::array<Pair, 192> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, 0, distance(a.nodes()[0], b.nodes()[0])};
  while (depth > 0) {
    const Pair pair = stack[--depth];
    const double far = limit();
    if (!(far > 0) || !(pair.squared < far * far)) continue;
    const TriangleTree::Node& in_a = a.nodes()[pair.a];
    const TriangleTree::Node& in_b = b.nodes()[pair.b];
    if (in_a.count > 0 && in_b.count > 0) {
      leaves(in_a, in_b);
      continue;
    }
    const bool split_a =
        in_a.count == 0 && (in_b.count > 0 || extentOf(in_a.box) >= extentOf(in_b.box));
    Pair first = pair, second = pair;
    if (split_a) {
      first.a = in_a.first;
      second.a = in_a.first + 1;
    } else {
      first.b = in_b.first;
      second.b = in_b.first + 1;
    }
    first.squared = distance(a.nodes()[first.a], b.nodes()[first.b]);
    second.squared = distance(a.nodes()[second.a], b.nodes()[second.b]);
    if (first.squared < second.squared) std::swap(first, second);
    stack[depth++] = first;
    stack[depth++] = second;
  }
}

/// The end of a body along a direction, in its own space.
double endAlong(const Vec3& direction, const TriangleTree& tree) {
  const auto reach = [&](std::uint32_t node) {
    const TriangleTree::Box& box = tree.nodes()[node].box;
    return dotOf(direction, box.centre) + std::fabs(direction.x) * box.half.x +
           std::fabs(direction.y) * box.half.y + std::fabs(direction.z) * box.half.z;
  };
  double end = -std::numeric_limits<double>::infinity();
  struct Ahead {
    std::uint32_t node;
    double reach;
  };
  std::array<Ahead, 96> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, reach(0)};
  while (depth > 0) {
    const Ahead ahead = stack[--depth];
    if (!(ahead.reach > end)) continue;
    const TriangleTree::Node& node = tree.nodes()[ahead.node];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Solid& solid = tree.solids()[i];
      for (const Vec3& corner : solid.triangle) {
        end = std::max(end, dotOf(direction, corner) + solid.radius_m);
      }
    }
    if (node.count > 0) continue;
    Ahead first{node.first, reach(node.first)}, second{node.first + 1, reach(node.first + 1)};
    if (first.reach > second.reach) std::swap(first, second);
    stack[depth++] = first;
    stack[depth++] = second;
  }
  return end;
}

}  // namespace

double gapAlong(const Vec3& direction, const TriangleTree& a, const TriangleTree& b,
                const Mat4& a_in_b) {
  if (a.empty() || b.empty()) return std::numeric_limits<double>::infinity();
  const auto along = [&](int axis) { return dotOf(Vec3(a_in_b[axis]), direction); };
  const double end_of_a =
      endAlong({along(0), along(1), along(2)}, a) + dotOf(direction, positionOf(a_in_b));
  return -endAlong(direction * -1.0, b) - end_of_a - kRounding_m;
}

TriangleTree::TriangleTree(std::vector<Solid> solids) : solids_(std::move(solids)) {
  if (solids_.empty()) return;
  nodes_.reserve(2 * solids_.size());
  nodes_.emplace_back();
  build(0, 0, static_cast<std::uint32_t>(solids_.size()));
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

TreeContact treeDistance(const TriangleTree& a, const TriangleTree& b, const Mat4& a_in_b,
                         const TreeContact* known) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  return boundedDistance(a, b, a_in_b, {kAny, kAny}, known).contact;
}

BoundedDistance boundedDistance(const TriangleTree& a, const TriangleTree& b, const Mat4& a_in_b,
                                const DistanceNeed& need, const TreeContact* known) {
  TreeContact least;
  if (a.empty() || b.empty()) return {least, least.distance_m};
  // Never grows: what was left out is not nearer than its last value.
  const auto limit = [&] {
    const double found = least.distance_m;
    if (found < need.near_m) return std::min(found, need.exact_below_m);
    return std::min(found, std::max({need.near_m, need.exact_below_m, found / 2}));
  };
  BestDirection direction;
  const auto offer = [&](std::uint32_t i, std::uint32_t j) {
    const Solid& solid_a = a.solids()[i];
    const Solid& solid_b = b.solids()[j];
    const Triangle at = placed(a_in_b, solid_a.triangle);
    const double apart = direction.gap(at, solid_b.triangle) - solid_a.radius_m - solid_b.radius_m;
    if (apart > limit() + kRounding_m) return;
    take(solidDistance(solid_a, at, solid_b), i, j, false, least);
    direction.follow(least);
  };
  if (known != nullptr && known->solid_a < a.size() && known->solid_b < b.size()) {
    offer(known->solid_a, known->solid_b);
  }
  visitPairs(
      a, b,
      [&](const TriangleTree::Node& in_a, const TriangleTree::Node& in_b) {
        const TriangleTree::Box box = boxIn(a_in_b, in_a.box);
        return std::max(squaredGap(box, in_b.box), direction.squared(direction.gap(box, in_b.box)));
      },
      limit,
      [&](const TriangleTree::Node& in_a, const TriangleTree::Node& in_b) {
        for (std::uint32_t i = in_a.first; i < in_a.first + in_a.count; ++i) {
          for (std::uint32_t j = in_b.first; j < in_b.first + in_b.count; ++j) offer(i, j);
        }
      });
  return {least, std::max(0.0, limit())};
}

bool sweepTrees(const TriangleTree& a, const TriangleTree& b, const TreeSweep& sweep, double cut_m,
                double tolerance_m, TreeContact& least) {
  if (a.empty() || b.empty()) return false;
  double lowest = std::numeric_limits<double>::infinity();
  const auto limit = [&] { return std::min(cut_m, least.distance_m - tolerance_m); };
  const auto judge = [&](std::uint32_t i, std::uint32_t j) {
    const Solid& solid_a = a.solids()[i];
    const Solid& solid_b = b.solids()[j];
    const Triangle start = placed(sweep.from, solid_a.triangle);
    const Triangle end = placed(sweep.to, solid_a.triangle);
    const NearestPoints at_start = solidDistance(solid_a, start, solid_b);
    const NearestPoints at_end = solidDistance(solid_a, end, solid_b);
    take(at_start, i, j, false, least);
    take(at_end, i, j, true, least);
    if (!(limit() > 0)) return;
    // Corners move along straight lines, within the bulge: their gap along one direction is then
    // least at an end, and a gap along any direction is a bound of the distance.
    // The third direction is that of the best so far: it settles what slides past beside it.
    const NearestPoints best{least.distance_m, least.on_a, least.on_b};
    double bound = 0;
    for (const NearestPoints* nearest : {&at_start, &at_end, &best}) {
      if (bound >= limit()) break;
      if (!(nearest->distance_m > 0) || !std::isfinite(nearest->distance_m)) continue;
      const Vec3 between = nearest->on_b - nearest->on_a;
      const double length = lengthOf(between);
      if (!(length > 0)) continue;
      const Vec3 direction = between * (1 / length);
      const double gap = std::min(gapAlong(direction, start, solid_b.triangle),
                                  gapAlong(direction, end, solid_b.triangle));
      bound = std::max(bound, gap - solid_a.radius_m - solid_b.radius_m - sweep.bulge_m);
    }
    lowest = std::min(lowest, bound);
  };
  if (least.solid_a < a.size() && least.solid_b < b.size()) judge(least.solid_a, least.solid_b);
  BestDirection direction;
  visitPairs(
      a, b,
      [&](const TriangleTree::Node& in_a, const TriangleTree::Node& in_b) {
        const TriangleTree::Box start = boxIn(sweep.from, in_a.box);
        const TriangleTree::Box end = boxIn(sweep.to, in_a.box);
        direction.follow(least);
        const double along =
            std::min(direction.gap(start, in_b.box), direction.gap(end, in_b.box)) - sweep.bulge_m;
        return std::max(squaredGap(hullOf(start, end, sweep.bulge_m), in_b.box),
                        direction.squared(along));
      },
      limit,
      [&](const TriangleTree::Node& in_a, const TriangleTree::Node& in_b) {
        for (std::uint32_t i = in_a.first; i < in_a.first + in_a.count; ++i) {
          for (std::uint32_t j = in_b.first; j < in_b.first + in_b.count; ++j) judge(i, j);
        }
      });
  return lowest < limit();
}

double displacement(const Mat4& from, const Mat4& to, const Vec3& centre, double radius_m) {
  double squared = 0;
  for (int column = 0; column < 3; ++column) {
    const Vec3 turned = Vec3(to[column]) - Vec3(from[column]);
    squared += dotOf(turned, turned);
  }
  // Two rotations that differ by a turn of t: 8 sin^2(t / 2), and no point turns farther than
  // 2 sin(t / 2) times its distance.
  return lengthOf(transformPoint(to, centre) - transformPoint(from, centre)) +
         std::sqrt(squared / 2) * radius_m;
}

}  // namespace rocinante
