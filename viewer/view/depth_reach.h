#pragma once

#include <span>

#include "viewer/view/camera.h"

namespace rocinante {

/// How far before and behind its eye an orthographic camera must reach: to all corners of boxes,
/// eight each as visibleCorners() has them, and to the grid. Where that is more than 128 m, as far
/// as what the picture shows of the boxes: a close view of a small part has fine depths, however
/// far the site goes on beside it. A power of two of at least a metre, so that small movements
/// change nobody's depth. The camera's own reach plays no part.
double depthReach(const Camera& camera, std::span<const Vec3> corners, double grid_m);

}  // namespace rocinante
