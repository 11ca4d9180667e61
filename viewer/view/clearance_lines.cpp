#include "viewer/view/clearance_lines.h"

#include "viewer/view/limit_levels.h"

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

void prepareExtras(const RenderStyle& style, const Cell& cell, const PosedScene& scene,
                   const SessionState& state, std::optional<ClearanceGauge>& gauge,
                   FrameExtras& extras) {
  extras.limits.clear();
  extras.clearances.clear();
  if (style.limits) extras.limits = limitLevels(scene, state);
  if (!style.clearance) return;
  if (!gauge) gauge.emplace(cell);
  extras.clearances = clearanceLines(cell, *gauge, state);
}

}  // namespace rocinante
