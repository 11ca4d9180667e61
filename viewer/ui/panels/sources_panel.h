#pragma once

#include "core/base/time.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// Draws a tab of the left panel.
void drawSourcesTab(ViewModel& model, SteadyTime now);

}  // namespace rocinante
