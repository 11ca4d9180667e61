#pragma once

#include <vector>

#include "core/cell/posed_scene.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// A ball in the world that holds more than it must: what it holds can be seen only when it can.
struct CullSphere {
  Vec3 center{};
  double radius_m = 0;
};

/// By link of a model: how far from the link's origin its geometry reaches, in the link's own
/// space; negative where it has none.
using LinkReaches = std::vector<double>;

/// The largest factor by which the matrix lengthens anything is at most this.
double scaleBound(const Mat4& m);

/// Around all geometry of a link.
CullSphere linkSphere(const PosedDevice& device, std::size_t link, double reach);
/// Around all geometry of a device, from where its links stand: no mesh is looked at.
CullSphere deviceSphere(const PosedDevice& device, const LinkReaches& reaches);

/// False only when Camera::sees() is false of every sphere inside, whatever rounding did. What is
/// not finite may be seen.
bool mayBeSeen(const Camera& camera, const CullSphere& sphere);

}  // namespace rocinante
