#include <cmath>
#include <map>
#include <span>
#include <string_view>

#include "core/math/trigonometry.h"
#include "core/mesh/polygon.h"
#include "core/mesh/position_index.h"

namespace rocinante {
namespace {

constexpr std::size_t kSmoothedCorners = 256;

Vec3 positionOf(const LooseMesh& loose, std::size_t corner) {
  return Vec3(loose.positions[loose.corners[corner].position]);
}

Vec3 unitOrZero(const Vec3& v) {
  const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  return length > 0 ? Vec3(v.x / length, v.y / length, v.z / length) : Vec3(0.0);
}

/// The triangle's unit normal, or zero when it has no area.
Vec3 faceNormal(const LooseMesh& loose, std::size_t triangle) {
  const Vec3 a = positionOf(loose, triangle * 3);
  const Vec3 b = positionOf(loose, triangle * 3 + 1);
  const Vec3 c = positionOf(loose, triangle * 3 + 2);
  return unitOrZero(glm::cross(b - a, c - a));
}

/// The triangle's angle at one of its corners.
double angleAt(const LooseMesh& loose, std::size_t corner) {
  const std::size_t first = corner - corner % 3;
  const Vec3 at = positionOf(loose, corner);
  const Vec3 one = unitOrZero(positionOf(loose, first + (corner - first + 1) % 3) - at);
  const Vec3 other = unitOrZero(positionOf(loose, first + (corner - first + 2) % 3) - at);
  const Vec3 across = glm::cross(one, other);
  return arcTangent2(std::sqrt(glm::dot(across, across)), glm::dot(one, other));
}

/// Number of the part's group, by triangle: faces of different groups move apart, so they are not
/// smoothed over their border.
std::vector<std::uint32_t> groupOfTriangles(const LooseMesh& loose) {
  std::vector<std::uint32_t> groups(loose.corners.size() / 3, 0);
  std::map<std::string_view, std::uint32_t> numbers;
  for (const MeshPart& part : loose.parts) {
    const std::uint32_t group =
        numbers.emplace(part.group, static_cast<std::uint32_t>(numbers.size())).first->second;
    for (std::uint32_t i = 0; i < part.index_count / 3; ++i) {
      groups[part.first_index / 3 + i] = group;
    }
  }
  return groups;
}

/// Which triangles of one point share a normal.
class Smoothing {
 public:
  Smoothing(const LooseMesh& loose, double angle_deg)
      : smoothing_(loose.smoothing),
        group_(groupOfTriangles(loose)),
        // Slightly below the cosine: faces that meet at exactly the angle are smoothed.
        least_cosine_(cosine(radiansOf(angle_deg)) - 1e-9) {}

  /// `unit`: the normals of all triangles.
  bool joins(const std::vector<Vec3>& unit, std::size_t face, std::size_t other) const {
    if (group_[face] != group_[other]) return false;
    // A face without area has no normal and is smoothed with all others.
    if (unit[face] == Vec3(0.0)) return true;
    const std::uint32_t smoothing = of(face);
    if (smoothing != of(other)) return false;
    if (smoothing == kNone) return glm::dot(unit[face], unit[other]) >= least_cosine_;
    return smoothing != 0 || face == other;
  }

 private:
  std::uint32_t of(std::size_t triangle) const {
    return triangle < smoothing_.size() ? smoothing_[triangle] : kNone;
  }

  const std::vector<std::uint32_t>& smoothing_;
  const std::vector<std::uint32_t> group_;
  const double least_cosine_;
};

}  // namespace

void smoothNormals(LooseMesh& loose, double angle_deg) {
  const std::size_t corner_count = loose.corners.size();
  bool complete = true;
  for (const Corner& corner : loose.corners) complete = complete && corner.normal != kNone;
  if (complete) return;
  PositionIndex points(loose.positions.size());
  std::vector<std::uint32_t> point_of(loose.positions.size());
  for (std::size_t i = 0; i < loose.positions.size(); ++i) {
    point_of[i] = points.numberOf(loose.positions[i]);
  }
  // Corners by point, in file order within each: [first[p], first[p + 1]).
  std::vector<std::uint32_t> first(points.positions().size() + 1, 0);
  for (const Corner& corner : loose.corners) ++first[point_of[corner.position] + 1];
  for (std::size_t p = 1; p < first.size(); ++p) first[p] += first[p - 1];
  std::vector<std::uint32_t> at_point(corner_count);
  std::vector<std::uint32_t> next_free(first.begin(), first.end() - 1);
  for (std::size_t i = 0; i < corner_count; ++i) {
    at_point[next_free[point_of[loose.corners[i].position]]++] = static_cast<std::uint32_t>(i);
  }

  const std::size_t triangle_count = corner_count / 3;
  std::vector<Vec3> unit(triangle_count);
  for (std::size_t t = 0; t < triangle_count; ++t) unit[t] = faceNormal(loose, t);
  std::vector<double> angles(corner_count);
  for (std::size_t i = 0; i < corner_count; ++i) angles[i] = angleAt(loose, i);
  const Smoothing smoothing(loose, angle_deg);

  for (std::size_t p = 0; p + 1 < first.size(); ++p) {
    const std::span<const std::uint32_t> around(at_point.data() + first[p],
                                                first[p + 1] - first[p]);
    const std::size_t normals_before = loose.normals.size();
    for (const std::uint32_t own : around) {
      if (loose.corners[own].normal != kNone) continue;
      const std::size_t face = own / 3;
      Vec3 sum(0.0);
      if (around.size() > kSmoothedCorners) {
        sum = unit[face];
      } else {
        for (const std::uint32_t other : around) {
          if (smoothing.joins(unit, face, other / 3)) sum += unit[other / 3] * angles[other];
        }
      }
      sum = unitOrZero(sum);
      if (sum == Vec3(0.0)) sum = Vec3(0, 0, 1);
      const glm::vec3 normal(sum);
      std::size_t number = normals_before;
      const std::size_t compared_until =
          around.size() > kSmoothedCorners ? normals_before : loose.normals.size();
      while (number < compared_until && loose.normals[number] != normal) ++number;
      if (number >= compared_until) {
        number = loose.normals.size();
        loose.normals.push_back(normal);
      }
      loose.corners[own].normal = static_cast<std::uint32_t>(number);
    }
  }
}

}  // namespace rocinante
