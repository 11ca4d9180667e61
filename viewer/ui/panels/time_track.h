#pragma once

#include <imgui.h>

#include "viewer/ui/model/view_model.h"
#include "viewer/ui/panels/time_axis.h"

namespace rocinante {

/// Height of the track, in interface units.
constexpr float kTrackHeight = 48;

/// Draws the time line on its axis, from `top` on: packets and losses by source, the shown moment,
/// events, marks, findings, the part that is repeated, and a ruler. Applies the mouse.
void drawTrack(ViewModel& model, TimelineCursor& cursor, const TimeAxis& axis, float top,
               SteadyTime now);

/// Red, amber or grey.
ImU32 severityColor(Severity severity);

}  // namespace rocinante
