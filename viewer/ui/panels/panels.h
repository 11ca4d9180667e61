#pragma once

#include <optional>
#include <string>

#include "core/base/parallel_for.h"
#include "core/base/time.h"
#include "viewer/detail/detail_level.h"
#include "viewer/ui/commands/viewer_requests.h"
#include "viewer/ui/model/view_insets.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/panels/frame_times.h"

namespace rocinante {

/// What is being read.
struct LoadingStatus {
  std::string name;
  LoadProgress progress;
  std::string waits_for{};  ///< a sentence; empty: for nothing else
};

/// The program's status for the panels.
struct ViewerStatus {
  FrameHistory times;
  std::uint64_t triangles = 0;
  std::uint64_t draws = 0;
  std::string renderer;
  int rung = 0;             ///< of kDetailRungs
  bool rung_fixed = false;  ///< chosen by the user, not by the governor
  bool may_govern = false;  ///< fast profile with a user
  bool refined = false;     ///< at rest: everything is drawn, whatever the rung
  double target_fps = 30;
  bool coarse_ready = true;  ///< coarser meshes are ready
  bool drops_looks = false;  ///< shadows and contact are left out to be drawn in time
  bool tells_times = true;   ///< off under a script, for identical screenshots
  std::string notice;        ///< last action, such as a written picture; may be empty
  bool notice_is_fault = false;
  std::optional<LoadingStatus> loading;
};

/// Draws the panels over the scene and applies the input to `model`: scene, looks and events on the
/// left, figures and the selected device on the right, time at the bottom. Input for the program
/// goes to the requests. Returns the edges of the picture that they cover.
CoveredEdges drawPanels(ViewModel& model, const ViewerStatus& status, SteadyTime now,
                        ViewerRequests& requests);

}  // namespace rocinante
