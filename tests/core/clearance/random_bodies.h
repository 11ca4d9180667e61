#pragma once

#include <cstdint>
#include <vector>

#include "core/clearance/tree_distance.h"
#include "core/math/transform.h"

namespace rocinante::test {

/// The same numbers with every standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15U + 1) {}

  /// In [-size, size].
  double number(double size) {
    state_ ^= state_ << 13U;
    state_ ^= state_ >> 7U;
    state_ ^= state_ << 17U;
    return size * (static_cast<double>(state_ >> 11U) * 0x1p-52 - 1);
  }
  Vec3 point(double size) {
    const double x = number(size), y = number(size), z = number(size);
    return {x, y, z};
  }
  Triangle triangle(double size) {
    const Vec3 a = point(size), b = point(size), c = point(size);
    return {a, b, c};
  }
  Quat turn() {
    const double w = number(1), x = number(1), y = number(1), z = number(1);
    return normalized(Quat{w, x, y, z}).value_or(Quat{1, 0, 0, 0});
  }
  Mat4 placement(double size) {
    const Quat rotation = turn();
    return matrixOf({point(size), rotation});
  }
  /// Small triangles strewn over a cube, one in five with a radius.
  std::vector<Solid> solids(std::size_t count) {
    std::vector<Solid> solids;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 middle = point(0.5);
      Solid solid{triangle(0.1), i % 5 == 0 ? 0.05 + number(0.04) : 0.0};
      for (Vec3& corner : solid.triangle) corner += middle;
      solids.push_back(solid);
    }
    return solids;
  }

 private:
  std::uint64_t state_;
};

}  // namespace rocinante::test
