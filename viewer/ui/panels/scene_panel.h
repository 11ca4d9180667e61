#pragma once

#include "core/base/time.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/panels/panels.h"

namespace rocinante {

// Tabs of the panel on the left.
/// `bottom`: how far down the window its panel may reach, in pixels.
void drawSceneTab(ViewModel& model, float bottom, ViewerRequests& requests);
void drawEventsTab(ViewModel& model, SteadyTime now, ViewerRequests& requests);

}  // namespace rocinante
