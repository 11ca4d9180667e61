#include "viewer/passes/item_matrices.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rocinante {
namespace {

/// Inverse transpose up to a factor: enough for normals, which are normalized later.
glm::mat3 normalMatrix(const Mat4& m) {
  const Vec3 x(m[0]);
  const Vec3 y(m[1]);
  const Vec3 z(m[2]);
  const std::array columns{crossOf(y, z), crossOf(z, x), crossOf(x, y)};
  // Scaled to about one, because a float cannot hold the squares of very small scales.
  double largest = 0;
  for (const Vec3& column : columns) {
    for (int i = 0; i < 3; ++i) largest = std::max(largest, std::abs(column[i]));
  }
  const double scale = largest > 0 ? 1 / largest : 1;
  return {glm::vec3(columns[0] * scale), glm::vec3(columns[1] * scale),
          glm::vec3(columns[2] * scale)};
}

}  // namespace

ItemMatrices::ItemMatrices(const Mat4& world, const Camera& camera) {
  const Mat4 relative = camera.relative(world);
  clip_from_model = glm::mat4(camera.clipFromRelative() * relative);
  relative_from_model = glm::mat4(relative);
  normal_from_model = normalMatrix(relative);
}

}  // namespace rocinante
