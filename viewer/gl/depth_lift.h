#pragma once

#include <cstdint>

#include "viewer/gl/gl_table.h"

namespace rocinante {

/// Moves triangles towards the eye by `ranks` (negative: away), off the surface they lie in: see
/// docs/rendering.md, "Surfaces in one plane". A tenth of the surface's slope across a pixel covers
/// the rounding of its corners to 1/256 pixel; the units cover that of the depth. Depth grows
/// towards the eye, so a positive offset lifts.
inline void setDepthLift(const GlTable& gl, float ranks, float more_units = 0) {
  gl.PolygonOffset(0.1F * ranks, 64.0F * ranks + more_units);
}

}  // namespace rocinante
