#pragma once

#include "core/cell/posed_scene.h"
#include "viewer/overlay/overlay.h"
#include "viewer/view/frame_extras.h"
#include "viewer/view/render_style.h"
#include "viewer/view/view_choice.h"

namespace rocinante {

/// Adds the axes of the links that RenderStyle::frames names and that are shown, over everything:
/// x red, y green, z blue, all as long in the picture, whatever their distance. Those of a device
/// that no cell describes have its name.
void addLinkFrames(Overlay& overlay, const PosedScene& scene, const ViewChoice& choice,
                   const std::vector<std::string>& frames, const Camera& camera,
                   const TextAtlas& atlas);

/// Adds the distances of RenderStyle::measures, over everything: a line between two points, and its
/// length. Those with a missing device or link are left out.
void addMeasures(Overlay& overlay, const PosedScene& scene, const RenderStyle& style,
                 const TextAtlas& atlas);

/// Adds FrameExtras::clearances, over everything: a line between the nearest points with the
/// distance, green where it is kept and red where not; a dot where two touch.
void addClearances(Overlay& overlay, const std::vector<ClearanceLine>& lines, LengthUnit unit,
                   const TextAtlas& atlas);

/// Adds where the camera `shown` is and what it shows as far as `depth_m`: the outline of that part
/// of space, over everything. Nothing for a `camera` with perspective.
void addCameraCone(Overlay& overlay, const Camera& shown, double depth_m, const Camera& camera);

}  // namespace rocinante
