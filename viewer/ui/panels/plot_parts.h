#pragma once

#include <imgui.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "viewer/ui/model/view_model.h"

/// Small things of plots, for other panels too.
namespace rocinante {

/// The colour of a curve, by PlotBoard::Curve::color.
ImU32 curveColor(std::size_t number, float opacity = 1);

/// The colour of a state, by its text: the same everywhere.
ImU32 stateColor(std::string_view text);
/// That of a text on such a ground.
ImU32 inkOn(ImU32 ground);

/// The colour of text, fainter: for lines. Text would not be read.
ImU32 fadedInk(float part);

/// The part "x" and so on of the pose of what is selected: of a link in the space that poses are
/// shown in. Empty for a device whose pose no packet states, and without a log.
std::optional<SeriesKey> poseKeyOf(const ViewModel& model, const Selection& shown,
                                   const char* part);

/// The side of that button, and what is usually between it and a name, in interface units.
constexpr float kPlotButtonSide = 11, kPlotButtonGap = 5;

/// A small button that plots a value, or no longer does: filled with the curve's colour while it
/// does. Draws nothing without a log.
void drawPlotButton(ViewModel& model, const SeriesKey& key);

/// Begins to drag these values when the mouse leaves the last item with its button held. Nothing
/// without a log.
void dragFromItem(ViewModel& model, const std::vector<SeriesKey>& keys);

/// A text that can be dragged to the plots; an item like others.
void drawDraggable(ViewModel& model, const char* id, const std::string& text, ImGuiCol ink,
                   const std::vector<SeriesKey>& keys);

/// drawPlotButton() for several values at once, such as x, y and z.
void drawPlotButton(ViewModel& model, const char* id, const std::vector<SeriesKey>& keys);

}  // namespace rocinante
