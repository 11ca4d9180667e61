#pragma once

#include "core/base/time.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/panels/panels.h"

namespace rocinante {

/// Draws the tab of the left panel with the amount drawn and the frame's cost by stage.
void drawFrameTab(const ViewerStatus& status, ViewerRequests& requests);

/// Draws the session's figures in the top right corner or where the user put them, all or only the
/// most important; returns their bottom.
float drawFigures(const ViewModel& model, const ViewerStatus& status, SteadyTime now, bool brief,
                  PanelPlaces& places);

}  // namespace rocinante
