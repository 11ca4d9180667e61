#pragma once

#include "core/base/time.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// Draws the tab of the left panel with what `rocinante check` finds in the log: a click goes to a
/// finding's first moment, selects its device and explains it.
void drawFindingsTab(ViewModel& model, SteadyTime now);

}  // namespace rocinante
