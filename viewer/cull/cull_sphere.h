#pragma once

#include <vector>

#include "core/cell/posed_scene.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// A conservative bounding sphere in world space: its content is visible only if the sphere is.
struct CullSphere {
  Vec3 center{};
  double radius_m = 0;
};

/// By link of a model: the largest distance of its geometry from the link's origin, in link space;
/// negative without geometry.
using LinkReaches = std::vector<double>;

/// Upper bound of the matrix's scale.
double scaleBound(const Mat4& m);

/// Bounds all geometry of a link.
CullSphere linkSphere(const PosedDevice& device, std::size_t link, double reach);
/// Bounds all geometry of a device by its link poses, without reading meshes.
CullSphere deviceSphere(const PosedDevice& device, const LinkReaches& reaches);

/// False only when Camera::sees() is false for every sphere inside, with any rounding. True for
/// spheres that are not finite.
bool mayBeSeen(const Camera& camera, const CullSphere& sphere);

}  // namespace rocinante
