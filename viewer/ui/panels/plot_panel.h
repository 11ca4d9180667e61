#pragma once

#include "core/base/time.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/panels/time_axis.h"

namespace rocinante {

/// Height of the plots with their margin, in pixels of a window that high; 0 when none are shown.
float plotsHeight(const ViewModel& model, float window_height);

/// Draws the plots above the time line, on its axis, `bottom` being their lower edge: a lane for
/// each unit, names and values at the right. Applies the mouse.
void drawPlots(ViewModel& model, TimelineCursor& cursor, const TimeAxis& axis, float bottom,
               SteadyTime now);

/// Draws what is dragged and where it can be dropped: onto the plots, or a band above the time line
/// while there are none, and the time line. Plots it when it is dropped there.
void drawPlotDrag(ViewModel& model);

}  // namespace rocinante
