#include "core/clearance/tree_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "core/clearance/enclosure.h"
#include "core/math/transform.h"

namespace rocinante {
namespace {

/// More than that of a bound: what is as near as another to the last bit is not left out.
constexpr double kRounding_m = 1e-12;
/// The cosine of a turn of the line between the nearest points that is worth a new aim: 1 degree.
constexpr double kSameAim = 0.99985;

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

/// Visits pairs of nodes, nearer ones first. `distance(node_a, node_b)` squared; `limit()`: pairs
/// farther than it do not matter, and it may shrink; `solids(solid_a, solid_b)`: of two leaves.
template <class Distance, class Limit, class Solids>
void visitPairs(const TriangleTree& a, const TriangleTree& b, const Distance& distance,
                const Limit& limit, const Solids& solids) {
  struct Pair {
    std::uint32_t a, b;
    double squared;
  };
  // Each step takes one pair and adds two; trees are balanced, so this is deep enough for 2^32.
  std::array<Pair, 192> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, 0, distance(0, 0)};
  while (depth > 0) {
    const Pair pair = stack[--depth];
    const double far = limit();
    if (!(far > 0) || !(pair.squared < far * far)) continue;
    const TriangleTree::Node& in_a = a.nodes()[pair.a];
    const TriangleTree::Node& in_b = b.nodes()[pair.b];
    if (in_a.count > 0 && in_b.count > 0) {
      for (std::uint32_t i = in_a.first; i < in_a.first + in_a.count; ++i) {
        for (std::uint32_t j = in_b.first; j < in_b.first + in_b.count; ++j) solids(i, j);
      }
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
    first.squared = distance(first.a, first.b);
    second.squared = distance(second.a, second.b);
    if (first.squared < second.squared) std::swap(first, second);
    if (first.squared < far * far) stack[depth++] = first;
    if (second.squared < far * far) stack[depth++] = second;
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

/// The line between the nearest points so far: along it lies most of what could be nearer.
class TreeSearch::Direction {
 public:
  /// Aims both trees along the line between the middles, until there is a better one.
  Direction(TreeSearch& search, const TriangleTree& a, const TriangleTree& b,
            std::span<const Mat4> places, double more_m)
      : search_(search), places_(places), more_m_(more_m) {
    search_.a_.begin(a);
    search_.b_.begin(b);
    middles_ = b.centre() - transformPoint(places[0], a.centre());
  }

  /// Takes the line between the nearest points, unless it is nearly the one at hand.
  void follow(const TreeContact& least) {
    if (is_aimed_ && least.distance_m == followed_m_) return;
    followed_m_ = least.distance_m;
    const bool has_contact = least.distance_m > 0 && std::isfinite(least.distance_m);
    const Vec3 between = has_contact ? least.on_b - least.on_a : middles_;
    const double length = lengthOf(between);
    const Vec3 along = length > 0 && std::isfinite(length) ? between * (1 / length) : Vec3{1, 0, 0};
    if (is_aimed_ && (!has_contact || dotOf(along, along_) > kSameAim)) return;
    is_aimed_ = true;
    along_ = along;
    const Aim aim = aimAlong(along);
    search_.a_.aim(aim, places_, more_m_);
    search_.b_.aim(aim, std::span(&kAtRest, 1), 0);
  }

 private:
  static constexpr Mat4 kAtRest{1.0};

  TreeSearch& search_;
  std::span<const Mat4> places_;
  double more_m_ = 0;
  Vec3 middles_{}, along_{};
  double followed_m_ = 0;
  bool is_aimed_ = false;
};

BoundedDistance TreeSearch::bounded(const TriangleTree& a, const TriangleTree& b,
                                    const Mat4& a_in_b, const DistanceNeed& need,
                                    const TreeContact* known) {
  TreeContact least;
  if (a.empty() || b.empty()) return {least, least.distance_m};
  // Never grows: what was left out is not nearer than its last value.
  const auto limit = [&] {
    const double found = least.distance_m;
    if (found < need.near_m) return std::min(found, need.exact_below_m);
    return std::min(found, std::max({need.near_m, need.exact_below_m, found / 2}));
  };
  Direction direction(*this, a, b, std::span(&a_in_b, 1), 0);
  const auto measure = [&](std::uint32_t i, std::uint32_t j) {
    const Triangle at = placed(a_in_b, a.solids()[i].triangle);
    take(solidDistance(a.solids()[i], at, b.solids()[j]), i, j, false, least);
    direction.follow(least);
  };
  if (known != nullptr && known->solid_a < a.size() && known->solid_b < b.size()) {
    measure(known->solid_a, known->solid_b);
  } else {
    direction.follow(least);
  }
  visitPairs(
      a, b,
      [&](std::uint32_t in_a, std::uint32_t in_b) {
        return squaredGap(a_.ofNode(in_a), b_.ofNode(in_b));
      },
      limit,
      [&](std::uint32_t i, std::uint32_t j) {
        const double far = limit();
        if (squaredGap(a_.ofSolid(i), b_.ofSolid(j)) > far * far) return;
        measure(i, j);
      });
  const double at_least = std::max(0.0, limit());
  if (least.distance_m > 0) {
    if (const auto inside = enclosedPoint(a, b, a_in_b, at_least)) {
      least.distance_m = 0;
      least.on_a = least.on_b = *inside;
      return {least, 0};
    }
  }
  return {least, at_least};
}

bool TreeSearch::sweep(const TriangleTree& a, const TriangleTree& b, const TreeSweep& sweep,
                       double cut_m, double tolerance_m, TreeContact& least) {
  if (a.empty() || b.empty()) return false;
  double lowest = std::numeric_limits<double>::infinity();
  const auto limit = [&] { return std::min(cut_m, least.distance_m - tolerance_m); };
  const std::array<Mat4, 2> places{sweep.from, sweep.to};
  Direction direction(*this, a, b, places, sweep.bulge_m);
  const auto judge = [&](std::uint32_t i, std::uint32_t j) {
    const Solid& solid_a = a.solids()[i];
    const Solid& solid_b = b.solids()[j];
    const Triangle start = placed(sweep.from, solid_a.triangle);
    const Triangle end = placed(sweep.to, solid_a.triangle);
    const NearestPoints at_start = solidDistance(solid_a, start, solid_b);
    const NearestPoints at_end = solidDistance(solid_a, end, solid_b);
    take(at_start, i, j, false, least);
    take(at_end, i, j, true, least);
    direction.follow(least);
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
      const Vec3 along = between * (1 / length);
      const double gap = std::min(gapAlong(along, start, solid_b.triangle),
                                  gapAlong(along, end, solid_b.triangle));
      bound = std::max(bound, gap - solid_a.radius_m - solid_b.radius_m - sweep.bulge_m);
    }
    lowest = std::min(lowest, bound);
  };
  direction.follow(TreeContact{});
  if (least.solid_a < a.size() && least.solid_b < b.size()) judge(least.solid_a, least.solid_b);
  visitPairs(
      a, b,
      [&](std::uint32_t in_a, std::uint32_t in_b) {
        return squaredGap(a_.ofNode(in_a), b_.ofNode(in_b));
      },
      limit,
      [&](std::uint32_t i, std::uint32_t j) {
        const double far = limit();
        if (!(far > 0) || squaredGap(a_.ofSolid(i), b_.ofSolid(j)) >= far * far) return;
        judge(i, j);
      });
  return lowest < limit();
}

TreeContact treeDistance(const TriangleTree& a, const TriangleTree& b, const Mat4& a_in_b,
                         const TreeContact* known) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  return TreeSearch().bounded(a, b, a_in_b, {kAny, kAny}, known).contact;
}

double gapAlong(const Vec3& direction, const TriangleTree& a, const TriangleTree& b,
                const Mat4& a_in_b) {
  if (a.empty() || b.empty()) return std::numeric_limits<double>::infinity();
  const auto along = [&](int axis) { return dotOf(Vec3(a_in_b[axis]), direction); };
  const double end_of_a =
      endAlong({along(0), along(1), along(2)}, a) + dotOf(direction, positionOf(a_in_b));
  return -endAlong(direction * -1.0, b) - end_of_a - kRounding_m;
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
