#pragma once

#include <optional>
#include <string>

#include "core/base/time.h"
#include "viewer/detail/detail_level.h"
#include "viewer/ui/model/view_insets.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/panels/frame_times.h"

namespace rocinante {

/// What the panels tell of the program itself.
struct ViewerStatus {
  FrameHistory times;
  std::uint64_t triangles = 0;
  std::uint64_t draws = 0;
  std::string renderer;
  int rung = 0;             ///< of kDetailRungs
  bool rung_fixed = false;  ///< chosen by a person, not by the governor
  bool may_govern = false;  ///< fast profile, and a person at the window
  double target_fps = 30;
  bool coarse_ready = true;  ///< coarser meshes are made
  bool tells_times = true;   ///< not under a script: a screenshot must come out the same
  std::string notice;        ///< what was done last, such as a picture's file; empty: none
  bool notice_is_fault = false;
};

/// What the person asked the program for in this frame.
struct ViewerRequests {
  bool fit = false;
  bool fit_selected = false;
  bool reset = false;  ///< the camera stands as it did at the start
  bool evidence = false;
  bool close = false;
  std::optional<std::string> mark;
  std::optional<double> target_fps;
  /// A rung to stay on, or (-1) the governor's choice.
  std::optional<int> rung;
};

/// Draws the panels over the scene and applies what was pressed to `model`: the scene, its looks
/// and its events on the left, figures and the selected device on the right, time below. What is
/// not the model's is wished for. Answers what of the picture they cover.
CoveredEdges drawPanels(ViewModel& model, const ViewerStatus& status, SteadyTime now,
                        ViewerRequests& requests);

}  // namespace rocinante
