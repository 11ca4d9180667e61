#include "core/mesh/shapes.h"

#include <array>
#include <cmath>

#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

constexpr std::uint32_t kSegments = 48;  // around the axis
constexpr std::uint32_t kCapRings = 12;  // from a pole to the equator

/// Cosine and sine of turn i of `count`; the last is exactly the first, so that seams close.
Vec2 onCircle(std::uint32_t i, std::uint32_t count) {
  const double angle = 2 * kPi * static_cast<double>(i % count) / static_cast<double>(count);
  return {cosine(angle), sine(angle)};
}

class ShapeBuilder {
 public:
  std::uint32_t add(const Vec3& position, const Vec3& normal, double u, double v) {
    mesh_.vertices.push_back({glm::vec3(position), glm::vec3(normal),
                              glm::vec2(static_cast<float>(u), static_cast<float>(v))});
    return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
  }

  /// A ring of kSegments + 1 vertices (the seam twice: u is 0 and 1 there); its first number.
  /// `slope` is the normal's share outward and along z.
  std::uint32_t ring(double radius, double z, const Vec2& slope, double v) {
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (std::uint32_t i = 0; i <= kSegments; ++i) {
      const Vec2 at = onCircle(i, kSegments);
      add({radius * at.x, radius * at.y, z}, {slope.x * at.x, slope.x * at.y, slope.y},
          static_cast<double>(i) / kSegments, v);
    }
    return first;
  }

  /// The band between two rings, `low` below `high`. A ring that is a pole gives one triangle per
  /// segment, not two with one degenerate.
  void band(std::uint32_t low, std::uint32_t high, bool low_is_pole, bool high_is_pole) {
    for (std::uint32_t i = 0; i < kSegments; ++i) {
      if (!low_is_pole) triangle(low + i, low + i + 1, high + i + 1);
      if (!high_is_pole) triangle(low + i, high + i + 1, high + i);
    }
  }

  /// A disc at z that faces up or down.
  void disc(double radius, double z, bool up) {
    const Vec3 normal(0, 0, up ? 1 : -1);
    const std::uint32_t centre = add({0, 0, z}, normal, 0.5, 0.5);
    for (std::uint32_t i = 0; i < kSegments; ++i) {
      const Vec2 at = onCircle(i, kSegments);
      add({radius * at.x, radius * at.y, z}, normal, 0.5 + 0.5 * at.x,
          0.5 + (up ? 0.5 : -0.5) * at.y);
    }
    for (std::uint32_t i = 0; i < kSegments; ++i) {
      const std::uint32_t a = centre + 1 + i;
      const std::uint32_t b = centre + 1 + (i + 1) % kSegments;
      triangle(centre, up ? a : b, up ? b : a);
    }
  }

  /// Half a sphere around (0, 0, z), from its lower to its upper ring; texture v runs from
  /// `v_low` to `v_high`. The number of the ring at the equator.
  std::uint32_t hemisphere(double radius, double z, bool upper, double v_low, double v_high) {
    std::uint32_t before = 0, equator = 0;
    for (std::uint32_t k = 0; k <= kCapRings; ++k) {
      // Quarter turns from pole or equator; a whole circle has four times as many steps.
      const Vec2 at = onCircle(k, kCapRings * 4);
      const Vec2 slope = upper ? at : Vec2(at.y, -at.x);
      const bool pole = k == (upper ? kCapRings : 0);
      const Vec2 exact = pole ? Vec2(0, upper ? 1 : -1) : slope;
      const double share = static_cast<double>(k) / kCapRings;
      const std::uint32_t now =
          ring(radius * exact.x, z + radius * exact.y, exact, v_low + (v_high - v_low) * share);
      if (k > 0) band(before, now, !upper && k == 1, upper && pole);
      if (k == (upper ? 0 : kCapRings)) equator = now;
      before = now;
    }
    return equator;
  }

  Mesh finish() {
    mesh_.materials.emplace_back();
    mesh_.parts.push_back({"", 0, 0, static_cast<std::uint32_t>(mesh_.indices.size())});
    for (const Vertex& vertex : mesh_.vertices) mesh_.bounds.add(Vec3(vertex.position));
    return std::move(mesh_);
  }

 private:
  Mesh mesh_;
};

}  // namespace

Mesh boxMesh(const Vec3& size) {
  // Each face as its outward axis and two axes that run right and up on it, seen from outside.
  struct Face {
    Vec3 out, right, up;
  };
  static constexpr std::array<Face, 6> kFaces = {
      Face{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},  Face{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
      Face{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}, Face{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
      Face{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},  Face{{0, 0, -1}, {1, 0, 0}, {0, -1, 0}}};
  ShapeBuilder shape;
  const Vec3 half = size * 0.5;
  for (const Face& face : kFaces) {
    const auto corner = [&](double right, double up) {
      return shape.add((face.out + face.right * right + face.up * up) * half, face.out,
                       0.5 + 0.5 * right, 0.5 + 0.5 * up);
    };
    const std::uint32_t first = corner(-1, -1);
    corner(1, -1);
    corner(1, 1);
    corner(-1, 1);
    shape.triangle(first, first + 1, first + 2);
    shape.triangle(first, first + 2, first + 3);
  }
  return shape.finish();
}

Mesh cylinderMesh(double radius, double length) {
  ShapeBuilder shape;
  const std::uint32_t low = shape.ring(radius, -length / 2, {1, 0}, 0);
  const std::uint32_t high = shape.ring(radius, length / 2, {1, 0}, 1);
  shape.band(low, high, false, false);
  shape.disc(radius, length / 2, true);
  shape.disc(radius, -length / 2, false);
  return shape.finish();
}

Mesh sphereMesh(double radius) {
  ShapeBuilder shape;
  shape.hemisphere(radius, 0, false, 0, 0.5);
  shape.hemisphere(radius, 0, true, 0.5, 1);
  return shape.finish();
}

Mesh capsuleMesh(double radius, double length) {
  ShapeBuilder shape;
  const double whole = length + 2 * radius;
  const double cap = whole > 0 ? radius / whole : 0.5;
  const std::uint32_t low = shape.hemisphere(radius, -length / 2, false, 0, cap);
  const std::uint32_t high = shape.hemisphere(radius, length / 2, true, 1 - cap, 1);
  shape.band(low, high, false, false);
  return shape.finish();
}

}  // namespace rocinante
