#pragma once

#include "viewer/cull/scene_catalog.h"
#include "viewer/detail/detail_level.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// Bounding sphere of a part in world space.
struct PartSphere {
  Vec3 center{};
  double radius_m = 0;
  double scale = 1;  ///< largest scale factor of the mesh
};

/// Whether the level leaves the part out: its sphere is smaller than cull_below_px across.
bool tooSmall(const PartSphere& sphere, const Camera& camera, const DetailLevel& level);

/// The coarsest version of the part with an error of at most geometry_error_px at its point nearest
/// to the eye; null: the part itself. Pure: depends only on camera and level.
const CoarsePart* coarseVersion(const CatalogPart& part, const PartSphere& sphere,
                                const Camera& camera, const DetailLevel& level);

}  // namespace rocinante
