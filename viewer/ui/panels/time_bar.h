#pragma once

#include "core/base/time.h"
#include "viewer/ui/model/timeline_cursor.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// Draws the time line at the bottom, with its events.
void drawTimeBar(ViewModel& model, TimelineCursor& cursor, SteadyTime now);

}  // namespace rocinante
