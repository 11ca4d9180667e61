#pragma once

#include "core/base/time.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/panels/panels.h"

namespace rocinante {

/// How much is drawn and what a frame costs, stage by stage: a tab of the panel on the left.
void drawFrameTab(const ViewerStatus& status, ViewerRequests& requests);

/// What is said of the session in the top right corner, all or the most needed; answers where it
/// ends.
float drawFigures(const ViewModel& model, const ViewerStatus& status, SteadyTime now, bool brief);

}  // namespace rocinante
