#include "viewer/view/frame_extras.h"

#include "viewer/view/clearance_lines.h"
#include "viewer/view/limit_levels.h"

namespace rocinante {

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
