#pragma once

#include "viewer/ui/panels/plot_lane.h"

namespace rocinante {

/// Draws a placed lane into the window that is open: its ground and scale, limits, curves or bands,
/// and those of the session beside. `looked_at`: the curve that stands out; null: none.
void drawLane(const ViewModel& model, const PlotLane& lane, const TimeAxis& axis,
              const PlotBoard::Curve* looked_at);

}  // namespace rocinante
