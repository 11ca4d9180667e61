#pragma once

#include <optional>
#include <vector>

#include "core/cell/posed_scene.h"
#include "core/clearance/clearance_gauge.h"
#include "viewer/view/frame_extras.h"
#include "viewer/view/render_style.h"

namespace rocinante {

/// The lines of the cell's clearances in a state, in their order. `gauge` is of the same cell.
std::vector<ClearanceLine> clearanceLines(const Cell& cell, ClearanceGauge& gauge,
                                          const SessionState& state);

/// What the style draws of a state beside the devices of its scene, trails left out. Before ghosts
/// of another session are in the scene: limits and clearances are not theirs. `gauge` is made on
/// first use.
void prepareExtras(const RenderStyle& style, const Cell& cell, const PosedScene& scene,
                   const SessionState& state, std::optional<ClearanceGauge>& gauge,
                   FrameExtras& extras);

}  // namespace rocinante
