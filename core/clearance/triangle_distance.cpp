#include "core/clearance/triangle_distance.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace rocinante {
namespace {

struct SquaredNearest {
  double squared = std::numeric_limits<double>::infinity();
  Vec3 on_a{}, on_b{};

  void offer(const Vec3& a, const Vec3& b) {
    const Vec3 between = a - b;
    const double candidate = dotOf(between, between);
    if (!(candidate < squared)) return;
    squared = candidate;
    on_a = a;
    on_b = b;
  }
};

/// The nearest points of the segments from `p` by `d` and from `q` by `e`.
void offerSegments(const Vec3& p, const Vec3& d, const Vec3& q, const Vec3& e,
                   SquaredNearest& nearest) {
  const Vec3 r = p - q;
  const double a = dotOf(d, d), b = dotOf(d, e), c = dotOf(d, r), f = dotOf(e, e), g = dotOf(e, r);
  double s = 0, t = 0;
  if (a <= 0 && f <= 0) return nearest.offer(p, q);
  if (a <= 0) {
    t = std::clamp(g / f, 0.0, 1.0);
  } else if (f <= 0) {
    s = std::clamp(-c / a, 0.0, 1.0);
  } else {
    const double area = a * f - b * b;
    if (area > 0) s = std::clamp((b * g - c * f) / area, 0.0, 1.0);
    t = (b * s + g) / f;
    if (t < 0) {
      t = 0;
      s = std::clamp(-c / a, 0.0, 1.0);
    } else if (t > 1) {
      t = 1;
      s = std::clamp((b - c) / a, 0.0, 1.0);
    }
  }
  nearest.offer(p + d * s, q + e * t);
}

/// A triangle with its plane.
struct Face {
  const Triangle& corners;
  Vec3 along, across, normal;
  double normal_squared;

  explicit Face(const Triangle& triangle)
      : corners(triangle),
        along(triangle[1] - triangle[0]),
        across(triangle[2] - triangle[0]),
        normal(crossOf(along, across)),
        normal_squared(dotOf(normal, normal)) {}

  bool hasPlane() const { return normal_squared > 0; }
  double height(const Vec3& point) const { return dotOf(normal, point - corners[0]); }

  /// Whether the point, which is taken into the plane, is within the triangle.
  bool covers(const Vec3& point) const {
    const Vec3 from = point - corners[0];
    const double u = dotOf(crossOf(from, across), normal);
    const double v = dotOf(crossOf(along, from), normal);
    return u >= 0 && v >= 0 && u + v <= normal_squared;
  }

  Vec3 foot(const Vec3& point) const { return point - normal * (height(point) / normal_squared); }
};

/// Where an edge from `p` to `q` goes through the face.
std::optional<Vec3> piercing(const Face& face, const Vec3& p, const Vec3& q) {
  const double below = face.height(p), above = face.height(q);
  if ((below > 0) == (above > 0) || below == above) return std::nullopt;
  const Vec3 point = p + (q - p) * (below / (below - above));
  if (!face.covers(point)) return std::nullopt;
  return point;
}

/// Whether the corners of a triangle are all on one side of the face's plane, none in it.
bool isOnOneSide(const Face& face, const Triangle& other) {
  const double a = face.height(other[0]), b = face.height(other[1]), c = face.height(other[2]);
  return (a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0);
}

std::optional<Vec3> crossing(const Face& a, const Face& b) {
  if (!a.hasPlane() && !b.hasPlane()) return std::nullopt;  // segments: their edges meet
  if (a.hasPlane() && isOnOneSide(a, b.corners)) return std::nullopt;
  if (b.hasPlane() && isOnOneSide(b, a.corners)) return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    if (a.hasPlane()) {
      if (const auto point = piercing(a, b.corners[i], b.corners[next])) return point;
    }
    if (b.hasPlane()) {
      if (const auto point = piercing(b, a.corners[i], a.corners[next])) return point;
    }
  }
  return std::nullopt;
}

}  // namespace

NearestPoints triangleDistance(const Triangle& a, const Triangle& b) {
  const Face face_a(a), face_b(b);
  if (const auto point = crossing(face_a, face_b)) return {0, *point, *point};
  SquaredNearest nearest;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 edge_a = a[(i + 1) % 3] - a[i];
    for (std::size_t j = 0; j < 3; ++j) {
      offerSegments(a[i], edge_a, b[j], b[(j + 1) % 3] - b[j], nearest);
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (face_b.hasPlane() && face_b.covers(a[i])) nearest.offer(a[i], face_b.foot(a[i]));
    if (face_a.hasPlane() && face_a.covers(b[i])) nearest.offer(face_a.foot(b[i]), b[i]);
  }
  const double distance = std::sqrt(nearest.squared);
  return {distance < kTouching_m ? 0 : distance, nearest.on_a, nearest.on_b};
}

}  // namespace rocinante
