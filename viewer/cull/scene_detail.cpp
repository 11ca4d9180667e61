#include "viewer/cull/scene_detail.h"

#include <algorithm>

namespace rocinante {

bool tooSmall(const PartSphere& sphere, const Camera& camera, const DetailLevel& level) {
  if (level.cull_below_px <= 0) return false;
  const double depth = camera.depthOf(sphere.center);
  // A sphere around the eye is not small, whatever the depth of its centre.
  if (!camera.orthographic() && depth <= sphere.radius_m) return false;
  return 2 * sphere.radius_m < level.cull_below_px * camera.metersPerPixel(depth);
}

const CoarsePart* coarseVersion(const CatalogPart& part, const PartSphere& sphere,
                                const Camera& camera, const DetailLevel& level) {
  if (level.geometry_error_px <= 0 || part.coarser.empty()) return nullptr;
  const double nearest = std::max(camera.depthOf(sphere.center) - sphere.radius_m, camera.near());
  const double allowed_m = level.geometry_error_px * camera.metersPerPixel(nearest);
  const CoarsePart* chosen = nullptr;
  for (const CoarsePart& version : part.coarser) {
    if (version.error_m * sphere.scale > allowed_m) break;
    chosen = &version;
  }
  return chosen;
}

}  // namespace rocinante
