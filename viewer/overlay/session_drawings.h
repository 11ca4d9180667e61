#pragma once

#include <vector>

#include "core/cell/posed_scene.h"
#include "viewer/overlay/overlay.h"
#include "viewer/view/frame_extras.h"
#include "viewer/view/render_style.h"
#include "viewer/view/view_choice.h"

namespace rocinante {

// The owner (Overlay::setOwner) of added vertices is 1 + the index in `drawings`.

/// Adds the sources' lines and points in scene order. A missing part makes a gap.
void addLinesAndPoints(Overlay& overlay, const std::vector<PosedDrawing>& drawings,
                       const ViewChoice& choice);

/// Adds their labels, the farthest first, so that nearer labels cover farther ones; with `apart`
/// layout, nearer labels get better places.
void addLabels(Overlay& overlay, const std::vector<PosedDrawing>& drawings,
               const ViewChoice& choice, const Camera& camera, const TextAtlas& atlas,
               LabelStyle style = LabelStyle::beside);

/// Adds trails as ribbons that fade towards their old end, each with a colour by its index.
void addTrails(Overlay& overlay, const std::vector<Trail>& trails);

}  // namespace rocinante
