#pragma once

#include "core/base/time.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/panels/panels.h"

namespace rocinante {

// Tabs of the left panel.
/// `bottom`: lowest pixel of the window that its panel may use.
void drawSceneTab(ViewModel& model, float bottom, ViewerRequests& requests);
void drawEventsTab(ViewModel& model, SteadyTime now, ViewerRequests& requests);

}  // namespace rocinante
