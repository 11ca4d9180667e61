#pragma once

#include <vector>

#include "viewer/view/camera.h"

namespace rocinante {

/// The view of the key light over all that can be seen, for a square shadow map.
struct ShadowFit {
  CameraView view;     ///< orthographic, looking along the light
  double reach_m = 1;  ///< as Camera takes it
  double texel_m = 1;  ///< what a texel covers
};

/// Fits it so that shadows stand still while things move: its directions follow from the light
/// alone, its size is one of four to the power of two, and its place a whole number of texels from
/// the world's origin. Points that are not finite, or farther than 1e7 m off, cast and take none.
ShadowFit shadowFit(const std::vector<Vec3>& corners, const Vec3& towards_light, int map_side);

}  // namespace rocinante
