#pragma once

#include "core/mesh/mesh_builder.h"

namespace rocinante {

/// Gives every corner without a normal one: the mean, weighted by their angles there, over the
/// faces that share its point (equal coordinates) and its group and meet its own face at
/// `angle_deg` or less. The sums are taken in file order with core/math's trigonometry, so they are
/// the same on every CPU. A point in more than 256 corners keeps its faces flat (the work is
/// squared in their number).
void smoothNormals(LooseMesh& loose, double angle_deg);

}  // namespace rocinante
