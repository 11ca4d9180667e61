#pragma once

#include "viewer/cull/scene_catalog.h"
#include "viewer/detail/detail_level.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// Where a part stands in the world, as culling sees it.
struct PartSphere {
  Vec3 center{};
  double radius_m = 0;
  double scale = 1;  ///< the largest factor by which the mesh is lengthened
};

/// Whether the level leaves the part out: its sphere is less than cull_below_px pixels across.
bool tooSmall(const PartSphere& sphere, const Camera& camera, const DetailLevel& level);

/// The coarsest version of the part that lies no more than geometry_error_px pixels off, judged
/// where the part comes nearest to the eye; null: the part itself. Pure: the camera and the level
/// alone decide, never what was drawn before.
const CoarsePart* coarseVersion(const CatalogPart& part, const PartSphere& sphere,
                                const Camera& camera, const DetailLevel& level);

}  // namespace rocinante
