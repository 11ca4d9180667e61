#pragma once

#include <vector>

#include "viewer/view/camera.h"

namespace rocinante {

/// The key light's view of everything visible, for a square shadow map.
struct ShadowFit {
  CameraView view;     ///< orthographic, looking along the light
  double reach_m = 1;  ///< for Camera
  double texel_m = 1;  ///< size of a texel
};

/// Fits the view so that shadows do not flicker while objects move: its directions depend only on
/// the light, its size has four steps per power of two, and its position is a whole number of
/// texels from the world's origin. Points that are not finite or farther than 1e7 m are ignored.
ShadowFit shadowFit(const std::vector<Vec3>& corners, const Vec3& towards_light, int map_side);

}  // namespace rocinante
