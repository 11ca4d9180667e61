#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include "viewer/view/camera.h"

namespace rocinante {

/// Transforms of an item's points and normals. Computed in double relative to the eye, then
/// converted to float, so that nothing jitters a kilometre from the origin.
struct ItemMatrices {
  glm::mat4 clip_from_model;
  glm::mat4 relative_from_model;  ///< world axes, origin at the eye
  glm::mat3 normal_from_model;    ///< normals have any length

  ItemMatrices(const Mat4& world, const Camera& camera);
};

}  // namespace rocinante
