#include "viewer/render/coplanar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace rocinante {
namespace {

constexpr std::uint32_t kMaxRank = 15;
/// Beyond so many pairs of triangles in one plane, two parts whose boxes overlap count as
/// overlapping.
constexpr std::size_t kMaxPairs = 200'000;

struct Triangle {
  std::uint32_t part = 0;
  std::array<Vec2, 3> corners;  ///< in the plane: the two axes other than the normal's largest
};

/// A plane, rounded. Both of its sides are one plane.
using PlaneKey = std::tuple<std::int64_t, std::int64_t, std::int64_t, std::int64_t>;

Vec3 crossOf(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dotOf(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

struct Box {
  Vec2 min{1e300, 1e300};
  Vec2 max{-1e300, -1e300};
  void add(const Vec2& p) {
    min = {std::min(min.x, p.x), std::min(min.y, p.y)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y)};
  }
  bool overlaps(const Box& other, double slack) const {
    return min.x + slack < other.max.x && other.min.x + slack < max.x &&
           min.y + slack < other.max.y && other.min.y + slack < max.y;
  }
};

/// Whether the insides overlap by more than `slack`: no edge of either separates them.
bool overlap(const Triangle& a, const Triangle& b, double slack) {
  for (const Triangle* triangle : {&a, &b}) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2 edge = triangle->corners[(i + 1) % 3] - triangle->corners[i];
      const double length = std::sqrt(edge.x * edge.x + edge.y * edge.y);
      if (length <= slack) return false;
      const Vec2 across(-edge.y / length, edge.x / length);
      const auto extent = [&](const Triangle& t) {
        std::pair<double, double> span{1e300, -1e300};
        for (const Vec2& corner : t.corners) {
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

/// Adds to `pairs` the parts (lower, higher number) that overlap among these triangles of one
/// plane.
void findPairs(const std::vector<Triangle>& triangles, double slack,
               std::set<std::pair<std::uint32_t, std::uint32_t>>& pairs) {
  std::map<std::uint32_t, std::pair<Box, std::vector<const Triangle*>>> by_part;
  for (const Triangle& triangle : triangles) {
    auto& [box, members] = by_part[triangle.part];
    for (const Vec2& corner : triangle.corners) box.add(corner);
    members.push_back(&triangle);
  }
  for (auto a = by_part.begin(); a != by_part.end(); ++a) {
    for (auto b = std::next(a); b != by_part.end(); ++b) {
      const auto& [a_box, a_members] = a->second;
      const auto& [b_box, b_members] = b->second;
      if (pairs.contains({a->first, b->first}) || !a_box.overlaps(b_box, slack)) continue;
      bool found = a_members.size() * b_members.size() > kMaxPairs;
      for (std::size_t i = 0; i < a_members.size() && !found; ++i) {
        for (std::size_t j = 0; j < b_members.size() && !found; ++j) {
          found = overlap(*a_members[i], *b_members[j], slack);
        }
      }
      if (found) pairs.emplace(a->first, b->first);
    }
  }
}

}  // namespace

std::vector<std::uint32_t> coplanarRanks(const Mesh& mesh) {
  std::vector<std::uint32_t> ranks(mesh.parts.size(), 0);
  if (mesh.parts.size() < 2 || mesh.bounds.empty()) return ranks;
  const Vec3 size = mesh.bounds.max - mesh.bounds.min;
  const double slack = std::max({size.x, size.y, size.z}) * 1e-5;
  if (!(slack > 0)) return ranks;

  std::vector<double> area(mesh.parts.size(), 0);
  std::map<PlaneKey, std::vector<Triangle>> planes;
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
      // One sign for both sides: the largest component is positive.
      int largest = 0;
      for (int axis = 1; axis < 3; ++axis) {
        if (std::abs(normal[axis]) > std::abs(normal[largest]) + 1e-9) largest = axis;
      }
      if (normal[largest] < 0) normal = -normal;
      const auto rounded = [](double value) {
        return static_cast<std::int64_t>(std::floor(value));
      };
      const double offset = dotOf(normal, p[0]) / (8 * slack);
      Triangle triangle{part, {}};
      for (std::size_t corner = 0; corner < 3; ++corner) {
        triangle.corners[corner] = {p[corner][(largest + 1) % 3], p[corner][(largest + 2) % 3]};
      }
      const PlaneKey key{rounded(normal.x * 256 + 0.5), rounded(normal.y * 256 + 0.5),
                         rounded(normal.z * 256 + 0.5), rounded(offset)};
      planes[key].push_back(triangle);
      // Also into the neighbouring plane that is closer: two of one plane must meet in some bucket
      // on whichever side of a rounding edge they fall.
      PlaneKey neighbour = key;
      std::get<3>(neighbour) += offset - std::floor(offset) < 0.5 ? -1 : 1;
      planes[neighbour].push_back(triangle);
    }
  }

  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const auto& [key, triangles] : planes) findPairs(triangles, slack, pairs);
  if (pairs.empty()) return ranks;

  // Largest first, so that each part comes after all that it may lie on.
  std::vector<std::uint32_t> order(mesh.parts.size());
  for (std::uint32_t part = 0; part < order.size(); ++part) order[part] = part;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return area[a] > area[b]; });
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  std::map<std::uint32_t, std::vector<std::uint32_t>> lies_on;
  for (const auto& [a, b] : pairs) {
    if (place[a] < place[b]) {
      lies_on[b].push_back(a);
    } else {
      lies_on[a].push_back(b);
    }
  }
  for (const std::uint32_t part : order) {
    for (const std::uint32_t below : lies_on[part]) {
      ranks[part] = std::max(ranks[part], std::min(ranks[below] + 1, kMaxRank));
    }
  }
  return ranks;
}

}  // namespace rocinante
