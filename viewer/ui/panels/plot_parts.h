#pragma once

#include <imgui.h>

#include <cstddef>
#include <string>

#include "viewer/ui/model/view_model.h"

/// Small things of plots, for other panels too.
namespace rocinante {

/// The colour of a curve, by PlotBoard::Curve::color.
ImU32 curveColor(std::size_t number, int alpha = 255);

/// The colour of text, fainter.
ImU32 fadedInk(float part);

/// A small button that plots a value, or no longer does: filled with the curve's colour while it
/// does. Draws nothing without a log.
void drawPlotButton(ViewModel& model, const SeriesKey& key);

/// The same for several values at once, such as x, y and z.
void drawPlotButton(ViewModel& model, const char* id, const std::vector<SeriesKey>& keys);

}  // namespace rocinante
