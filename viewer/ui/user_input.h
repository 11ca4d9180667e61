#pragma once

#include "core/time.h"
#include "viewer/ui/view_model.h"

namespace rocinante {

class Window;

/// Mouse and keyboard of this frame, as Dear ImGui has them and has not used them itself: left drag
/// turns, middle or right drag (or Shift and left) pans, the wheel zooms; Space plays and pauses,
/// arrows step, Home and End jump, 1 to 9 choose a camera, F fits, Tab hides the panels, Q closes.
void applyUserInput(ViewModel& model, SteadyTime now, int height_px, bool& fit_requested,
                    Window& window);

}  // namespace rocinante
