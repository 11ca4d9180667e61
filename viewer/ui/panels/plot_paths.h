#pragma once

#include <optional>

#include "viewer/ui/panels/plot_lane.h"

namespace rocinante {

/// Where the x-y plots lie, in pixels: side by side, below the lanes of curves.
struct PathRoom {
  float top = 0, height = 0;
};

/// How much of `height` they take; 0 without any.
float pathsHeight(const ViewModel& model, float height);

/// Draws them into the window that is open, each with its scales, its path through the shown time,
/// a dot where it is at the shown moment, and a fainter one at the mouse's; names and values are
/// right of the axis. `mouse`: the moment below the mouse; empty: none.
void drawPaths(ViewModel& model, const TimeAxis& axis, const PathRoom& room, LogTime shown,
               std::optional<LogTime> mouse, float legend_width);

}  // namespace rocinante
