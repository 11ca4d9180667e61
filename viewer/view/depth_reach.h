#pragma once

#include <span>

#include "viewer/view/camera.h"

namespace rocinante {

/// The depth range in front of and behind the eye of an orthographic camera: to all corners of
/// boxes, eight each as in visibleCorners(), and the grid. Beyond 128 m, only to the visible part
/// of the boxes, so that a close view of a small part has precise depths on a large site. A power
/// of two of at least one metre, so that small movements do not change depths. Ignores the camera's
/// present reach.
double depthReach(const Camera& camera, std::span<const Vec3> corners, double grid_m);

}  // namespace rocinante
