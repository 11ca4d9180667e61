#pragma once

#include <vector>

#include "core/cell/posed_scene.h"
#include "viewer/overlay/overlay.h"
#include "viewer/view/frame_extras.h"
#include "viewer/view/render_style.h"
#include "viewer/view/view_choice.h"

namespace rocinante {

// What is added belongs (Overlay::setOwner) to 1 + its drawing's place in `drawings`.

/// The sources' lines and points, in the order of the scene. A part that never came is a gap.
void addLinesAndPoints(Overlay& overlay, const std::vector<PosedDrawing>& drawings,
                       const ViewChoice& choice);

/// Their labels, the farthest first, so that nearer ones cover farther ones; apart, the nearer
/// ones get the better places.
void addLabels(Overlay& overlay, const std::vector<PosedDrawing>& drawings,
               const ViewChoice& choice, const Camera& camera, const TextAtlas& atlas,
               LabelStyle style = LabelStyle::beside);

/// Trails as ribbons that fade towards their old end, each in a colour of its own by its place.
void addTrails(Overlay& overlay, const std::vector<Trail>& trails);

}  // namespace rocinante
