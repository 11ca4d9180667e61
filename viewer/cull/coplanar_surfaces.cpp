#include "viewer/cull/coplanar_surfaces.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace rocinante {
namespace {

constexpr std::uint32_t kMaxRank = 15;
constexpr std::size_t kMaxPairTests = 4'000'000;

/// A triangle projected along the largest axis of its normal.
struct FlatTriangle {
  std::uint32_t part = 0;
  std::uint32_t number = 0;  ///< of the triangle in the mesh
  bool reversed = false;     ///< faces against the plane's normal
  FlatCorners corners;
  Vec2 min{1e300, 1e300}, max{-1e300, -1e300};
};

/// A rounded plane; both sides give the same key.
using PlaneKey = std::array<std::int64_t, 4>;

/// Where a triangle lies: in its plane and in the nearer neighbouring one.
struct PlacedTriangle {
  FlatTriangle flat;
  PlaneKey plane, neighbour;
};

/// The triangles with an area, and sums the parts' areas.
std::vector<PlacedTriangle> placedTriangles(const Mesh& mesh, double slack,
                                            std::vector<double>& area) {
  std::vector<PlacedTriangle> placed;
  placed.reserve(mesh.triangleCount());
  for (std::uint32_t part = 0; part < mesh.parts.size(); ++part) {
    const MeshPart& run = mesh.parts[part];
    for (std::uint32_t i = 0; i + 2 < run.index_count; i += 3) {
      std::array<Vec3, 3> p;
      for (std::uint32_t corner = 0; corner < 3; ++corner) {
        p[corner] = Vec3(mesh.vertices[mesh.indices[run.first_index + i + corner]].position);
      }
      Vec3 normal = crossOf(p[1] - p[0], p[2] - p[0]);
      const double twice_area = std::sqrt(dotOf(normal, normal));
      if (!(twice_area > slack * slack)) continue;
      area[part] += twice_area / 2;
      normal /= twice_area;
      // One sign for both sides: the largest component is positive. By a margin, so that rounding
      // does not choose between equal ones.
      int largest = 0;
      for (int axis = 1; axis < 3; ++axis) {
        if (std::abs(normal[axis]) > std::abs(normal[largest]) + 1e-6) largest = axis;
      }
      FlatTriangle flat;
      flat.part = part;
      flat.number = (run.first_index + i) / 3;
      flat.reversed = normal[largest] < 0;
      if (flat.reversed) normal = -normal;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const Vec2 at(p[corner][(largest + 1) % 3], p[corner][(largest + 2) % 3]);
        flat.corners[corner] = at;
        flat.min = {std::min(flat.min.x, at.x), std::min(flat.min.y, at.y)};
        flat.max = {std::max(flat.max.x, at.x), std::max(flat.max.y, at.y)};
      }
      const auto whole = [](double value) { return static_cast<std::int64_t>(std::floor(value)); };
      const double offset = dotOf(normal, p[0]) / (8 * slack);
      const PlaneKey key{whole(normal.x * 256 + 0.5), whole(normal.y * 256 + 0.5),
                         whole(normal.z * 256 + 0.5), whole(offset)};
      // Also into the nearer neighbouring plane: two coplanar triangles must share a plane even if
      // rounding separates them.
      PlaneKey neighbour = key;
      neighbour[3] += offset - std::floor(offset) < 0.5 ? -1 : 1;
      placed.push_back({flat, key, neighbour});
    }
  }
  return placed;
}

std::size_t hashOf(const PlaneKey& key) {
  std::uint64_t hash = 0;
  for (const std::int64_t each : key) {
    hash = (hash ^ static_cast<std::uint64_t>(each)) * 0x9E3779B97F4A7C15U;
    hash ^= hash >> 29U;
  }
  return static_cast<std::size_t>(hash);
}

/// The planes that triangles of several parts share: few, so that only those are sorted. In the
/// order of their keys, each with its triangles in the mesh's order.
class SharedPlanes {
 public:
  explicit SharedPlanes(const std::vector<PlacedTriangle>& placed) : placed_(placed) {
    // By hash: the only part seen, or that there are several. Keys that meet cost time alone.
    std::vector<std::uint32_t> parts(std::bit_ceil(4 * placed.size() + 1), kNone);
    const auto seen = [&](const PlaneKey& key) -> std::uint32_t& {
      return parts[hashOf(key) & (parts.size() - 1)];
    };
    const auto mark = [&](const PlaneKey& key, std::uint32_t part) {
      std::uint32_t& only = seen(key);
      if (only != part) only = only == kNone ? part : kSeveral;
    };
    for (const PlacedTriangle& each : placed) {
      mark(each.plane, each.flat.part);
      mark(each.neighbour, each.flat.part);
    }
    for (std::uint32_t i = 0; i < placed.size(); ++i) {
      if (seen(placed[i].plane) == kSeveral) entries_.push_back({placed[i].plane, i});
      if (seen(placed[i].neighbour) == kSeveral) entries_.push_back({placed[i].neighbour, i});
    }
    std::ranges::sort(entries_);
  }

  /// The triangles of the next plane; false when there is none.
  bool next(std::vector<FlatTriangle>& triangles) {
    triangles.clear();
    const std::size_t first = at_;
    while (at_ < entries_.size() && entries_[at_].first == entries_[first].first) {
      triangles.push_back(placed_[entries_[at_++].second].flat);
    }
    return !triangles.empty();
  }

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU, kSeveral = 0xFFFFFFFEU;
  const std::vector<PlacedTriangle>& placed_;
  std::vector<std::pair<PlaneKey, std::uint32_t>> entries_;
  std::size_t at_ = 0;
};

using PartPair = std::pair<std::uint32_t, std::uint32_t>;  // lower number first

void findOverlaps(std::vector<FlatTriangle>& triangles, const std::vector<std::uint32_t>& bodies,
                  double slack, std::size_t& tests, std::set<PartPair>& same_way,
                  CoplanarSurfaces& surfaces) {
  // Sweep along x: only triangles with overlapping ranges are tested.
  std::stable_sort(triangles.begin(), triangles.end(),
                   [](const FlatTriangle& a, const FlatTriangle& b) { return a.min.x < b.min.x; });
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const FlatTriangle& a = triangles[i];
    for (std::size_t j = i + 1; j < triangles.size(); ++j) {
      const FlatTriangle& b = triangles[j];
      if (b.min.x + slack >= a.max.x || ++tests > kMaxPairTests) break;
      const bool boxes_meet = a.min.y + slack < b.max.y && b.min.y + slack < a.max.y;
      if (a.part == b.part || !boxes_meet || !trianglesOverlap(a.corners, b.corners, slack))
        continue;
      if (a.reversed != b.reversed) {
        if (!bodies.empty() && bodies[a.part] != bodies[b.part]) continue;
        surfaces.one_sided[a.number] = surfaces.one_sided[b.number] = 1;
        surfaces.any_one_sided = true;
      } else {
        same_way.insert(std::minmax(a.part, b.part));
      }
    }
  }
}

/// Ranks each part one above the highest part below it.
void rankParts(const std::vector<double>& area, const std::set<PartPair>& same_way,
               std::vector<std::uint32_t>& ranks) {
  std::vector<std::uint32_t> order(area.size());
  for (std::uint32_t part = 0; part < order.size(); ++part) order[part] = part;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return area[a] > area[b]; });
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  std::map<std::uint32_t, std::vector<std::uint32_t>> lies_on;
  for (const auto& [a, b] : same_way) {
    const bool b_above = place[a] < place[b];
    lies_on[b_above ? b : a].push_back(b_above ? a : b);
  }
  for (const std::uint32_t part : order) {
    for (const std::uint32_t below : lies_on[part]) {
      ranks[part] = std::max(ranks[part], std::min(ranks[below] + 1, kMaxRank));
    }
  }
}

}  // namespace

// Separating axis test over the edges of both.
bool trianglesOverlap(const FlatCorners& a, const FlatCorners& b, double slack) {
  for (const FlatCorners* triangle : {&a, &b}) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2 edge = (*triangle)[(i + 1) % 3] - (*triangle)[i];
      const double length = std::sqrt(edge.x * edge.x + edge.y * edge.y);
      if (length <= slack) return false;
      const Vec2 across(-edge.y / length, edge.x / length);
      const auto extent = [&](const FlatCorners& corners) {
        std::pair<double, double> span{1e300, -1e300};
        for (const Vec2& corner : corners) {
          const double at = corner.x * across.x + corner.y * across.y;
          span = {std::min(span.first, at), std::max(span.second, at)};
        }
        return span;
      };
      const auto [a_min, a_max] = extent(a);
      const auto [b_min, b_max] = extent(b);
      if (a_max <= b_min + slack || b_max <= a_min + slack) return false;
    }
  }
  return true;
}

CoplanarSurfaces coplanarSurfaces(const Mesh& mesh, const std::vector<std::uint32_t>& bodies) {
  CoplanarSurfaces surfaces;
  surfaces.ranks.assign(mesh.parts.size(), 0);
  surfaces.one_sided.assign(mesh.triangleCount(), 0);
  if (mesh.parts.size() < 2 || mesh.bounds.empty()) return surfaces;
  const Vec3 size = mesh.bounds.max - mesh.bounds.min;
  const double slack = std::max({size.x, size.y, size.z}) * 1e-5;
  if (!(slack > 0)) return surfaces;

  std::vector<double> area(mesh.parts.size(), 0);
  const std::vector<PlacedTriangle> placed = placedTriangles(mesh, slack, area);
  SharedPlanes planes(placed);
  std::set<PartPair> same_way;
  std::size_t tests = 0;
  for (std::vector<FlatTriangle> triangles; planes.next(triangles);) {
    findOverlaps(triangles, bodies, slack, tests, same_way, surfaces);
  }
  if (!same_way.empty()) rankParts(area, same_way, surfaces.ranks);
  return surfaces;
}

}  // namespace rocinante
