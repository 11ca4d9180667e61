#pragma once

#include <vector>

#include "core/clearance/clearance_gauge.h"
#include "viewer/view/frame_extras.h"

namespace rocinante {

/// The lines of the cell's clearances in a state, in their order. `gauge` is of the same cell.
std::vector<ClearanceLine> clearanceLines(const Cell& cell, ClearanceGauge& gauge,
                                          const SessionState& state);

}  // namespace rocinante
