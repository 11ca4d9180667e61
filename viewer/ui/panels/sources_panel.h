#pragma once

#include "core/base/time.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// A tab of the panel on the left.
void drawSourcesTab(ViewModel& model, SteadyTime now);

}  // namespace rocinante
