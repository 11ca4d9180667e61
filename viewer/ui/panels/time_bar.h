#pragma once

#include "core/base/time.h"
#include "viewer/ui/model/timeline_cursor.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/panels/time_axis.h"

namespace rocinante {

/// Draws the time line at the bottom: buttons, and the track below them.
void drawTimeBar(ViewModel& model, TimelineCursor& cursor, const TimeAxis& axis, SteadyTime now);

}  // namespace rocinante
