#pragma once

#include <optional>

#include "core/cell/cell.h"
#include "core/cell/posed_scene.h"
#include "core/cell/scene_pose_cache.h"
#include "core/clearance/clearance_gauge.h"
#include "core/session/timeline.h"
#include "viewer/view/frame_extras.h"
#include "viewer/view/render_style.h"
#include "viewer/view/trail_finder.h"

namespace rocinante {

/// Makes the scene of a state, and all FrameExtras of a style but `nearest`: for a window and for
/// `render` alike. Caches, which only affects the cost. Not thread-safe; borrows the cell.
class ScenePoser {
 public:
  explicit ScenePoser(const Cell& cell) : cell_(&cell), poses_(cell) {}

  /// The trails up to `time`; without a session (null) there are none. Before the session is asked
  /// for the state to be posed: this invalidates one borrowed from it. Damage of the log that
  /// affects trails is added to `damage`.
  Status findTrails(const RenderStyle& style, Timeline* session, LogTime time, StateDamage& damage,
                    FrameExtras& extras);
  /// Another log is asked from now on.
  void forgetTrails() { trails_.reset(); }

  /// The scene, with its limits and clearances. Ghosts of another session (BesideSession) are added
  /// to it afterwards: limits and clearances are not theirs.
  PosedScene pose(const RenderStyle& style, const SessionState& state, FrameExtras& extras);

 private:
  const Cell* cell_;
  ScenePoseCache poses_;
  // Made on first use.
  std::optional<TrailFinder> trails_;
  std::optional<ClearanceGauge> gauge_;
};

}  // namespace rocinante
