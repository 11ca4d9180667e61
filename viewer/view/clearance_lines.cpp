#include "viewer/view/frame_extras.h"

namespace rocinante {

std::vector<ClearanceLine> clearanceLines(const Cell& cell, ClearanceGauge& gauge,
                                          const SessionState& state) {
  std::vector<ClearanceLine> lines;
  for (const GapPlace& place : gauge.places(state)) {
    // What touches is a finding whatever the least distance is.
    const bool is_kept =
        place.distance_m > 0 && place.distance_m >= cell.clearances[place.clearance].min_m;
    lines.push_back({place.on_a, place.on_b, place.distance_m, is_kept});
  }
  return lines;
}

}  // namespace rocinante
