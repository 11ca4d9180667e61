#pragma once

#include "core/mesh/mesh_builder.h"

namespace rocinante {

/// Gives every corner without a normal the mean normal, weighted by angle, of the faces that share
/// its point (equal coordinates) and group and meet its face at `angle_deg` or less. The sums are
/// taken in file order with core/math's trigonometry, so they are the same on every CPU. A point in
/// more than 256 corners keeps its faces flat (the work is quadratic in their number).
void smoothNormals(LooseMesh& loose, double angle_deg);

}  // namespace rocinante
