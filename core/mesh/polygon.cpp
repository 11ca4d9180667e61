#include "core/mesh/polygon.h"

#include <cmath>

namespace rocinante {
namespace {

constexpr std::size_t kLargestConcave = 2048;

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

void flattenPolygon(std::span<const glm::vec3> corners, std::size_t outer,
                    std::vector<Vec2>& flat) {
  // Newell's normal: sound for concave and slightly bent polygons. Coordinates are taken from the
  // first corner, so that a polygon far from the origin keeps its digits.
  const Vec3 origin(corners[0]);
  Vec3 normal(0.0);
  for (std::size_t i = 0; i < outer; ++i) {
    const Vec3 a = Vec3(corners[i]) - origin;
    const Vec3 b = Vec3(corners[i + 1 == outer ? 0 : i + 1]) - origin;
    normal += glm::cross(a, b);
  }
  const double x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
  flat.clear();
  // Dropping the normal's largest coordinate keeps the shape and, with the sign, the winding.
  for (const glm::vec3& corner : corners) {
    const Vec3 p = Vec3(corner) - origin;
    if (z >= x && z >= y) {
      flat.emplace_back(normal.z < 0 ? -p.x : p.x, p.y);
    } else if (y >= x) {
      flat.emplace_back(normal.y < 0 ? -p.z : p.z, p.x);
    } else {
      flat.emplace_back(normal.x < 0 ? -p.y : p.y, p.z);
    }
  }
}

bool PolygonCutter::isStraight(std::size_t corner) const {
  return turn(flat_[previous_[corner]], flat_[corner], flat_[next_[corner]]) == 0;
}

bool PolygonCutter::isEar(std::size_t corner) const {
  const std::size_t before = previous_[corner], after = next_[corner];
  const Vec2 &a = flat_[before], &b = flat_[corner], &c = flat_[after];
  if (turn(a, b, c) <= 0) return false;
  for (std::size_t other = next_[after]; other != before; other = next_[other]) {
    const Vec2& p = flat_[other];
    // A corner on the ear's own points is a polygon that touches itself (a bridge to a hole).
    if (p == a || p == b || p == c) continue;
    if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
  }
  return true;
}

void PolygonCutter::clipEars() {
  const auto count = static_cast<std::uint32_t>(flat_.size());
  previous_.resize(count);
  next_.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    previous_[i] = i == 0 ? count - 1 : i - 1;
    next_[i] = i + 1 == count ? 0 : i + 1;
  }
  std::uint32_t corner = 0;
  std::uint32_t refused = 0;  // in a row: a full round without an ear means there is none
  for (std::uint32_t left = count; left > 3;) {
    // After a round without an ear, corners on a straight line are cut off. After a second one the
    // polygon crosses itself, and any corner is cut off, so that something is drawn and the loop
    // ends.
    const bool straight = refused >= left && isStraight(corner);
    if (refused < 2 * left && !straight && !isEar(corner)) {
      ++refused;
      corner = next_[corner];
      continue;
    }
    triangles_.insert(triangles_.end(), {previous_[corner], corner, next_[corner]});
    next_[previous_[corner]] = next_[corner];
    previous_[next_[corner]] = previous_[corner];
    // Forward, not back: cutting all around gives better shapes than a fan from one corner.
    corner = next_[next_[corner]];
    refused = 0;
    --left;
  }
  triangles_.insert(triangles_.end(), {previous_[corner], corner, next_[corner]});
}

std::span<const std::uint32_t> PolygonCutter::cut(std::span<const glm::vec3> corners) {
  triangles_.clear();
  gave_up_ = false;
  const auto count = static_cast<std::uint32_t>(corners.size());
  if (count > 3) {
    flattenPolygon(corners, corners.size(), flat_);
    bool convex = true;
    for (std::uint32_t i = 0; i < count && convex; ++i) {
      const Vec2& before = flat_[i == 0 ? count - 1 : i - 1];
      convex = turn(before, flat_[i], flat_[i + 1 == count ? 0 : i + 1]) >= 0;
    }
    if (!convex && count <= kLargestConcave) {
      clipEars();
      return triangles_;
    }
    gave_up_ = !convex;
  }
  for (std::uint32_t i = 1; i + 1 < count; ++i) {
    triangles_.insert(triangles_.end(), {0, i, i + 1});
  }
  return triangles_;
}

}  // namespace rocinante
