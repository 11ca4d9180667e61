#pragma once

#include "core/time.h"
#include "viewer/ui/view_model.h"

namespace rocinante {

/// Figures of the last frame, for the corner of the window.
struct FrameFigures {
  double frame_ms = 0;
  std::uint64_t triangles = 0;
  std::string renderer;
};

/// Colours and spacing of all panels; once, after the ImGui context was made.
void stylePanels();

/// Draws the panels over the scene and applies what was pressed to `model`: the scene's cameras,
/// layers and devices on the left, time below, figures at the right. `fit_requested` is set when
/// the person asks to see everything.
void drawPanels(ViewModel& model, const FrameFigures& figures, SteadyTime now, bool& fit_requested);

/// The time line at the bottom, with its events; part of drawPanels.
void drawTimeBar(ViewModel& model, Transport& transport, SteadyTime now);

}  // namespace rocinante
