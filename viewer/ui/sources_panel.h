#pragma once

#include "core/time.h"
#include "viewer/ui/view_model.h"

namespace rocinante {

/// A tab of the panel on the left.
void drawSourcesTab(ViewModel& model, SteadyTime now);

}  // namespace rocinante
