#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/model/cell.h"
#include "core/model/posed_scene.h"
#include "core/session/timeline.h"
#include "viewer/render/view_choice.h"
#include "viewer/ui/live_feed.h"
#include "viewer/ui/transport.h"
#include "viewer/ui/turntable.h"

namespace rocinante {

/// What the window shows and what the person in front of it chose: the state behind the panels,
/// without a window. One thread.
class ViewModel {
 public:
  /// The cell alone, a recorded session, or a live one: at most one of `session` and `feed`.
  static Result<ViewModel> make(Cell cell, std::optional<Timeline> session,
                                std::optional<LiveFeed> feed, std::vector<std::string> hide,
                                std::vector<std::string> show);

  const Cell& cell() const { return *cell_; }
  const SessionState& state() const { return *state_; }
  const PosedScene& scene() const { return scene_; }
  const ViewChoice& choice() const { return choice_; }

  /// Null without a log.
  Transport* transport() { return transport_ ? &*transport_ : nullptr; }
  LogTime origin() const { return session_ ? session_->origin() : LogTime{}; }
  const std::vector<Event>& events() const { return events_; }
  /// Null when not live, or when nothing has come yet.
  const LiveSnapshot* live() const { return live_.get(); }
  bool isLive() const { return feed_.has_value(); }
  const LiveFeed& feed() const { return *feed_; }
  const Timeline* session() const { return session_ ? &*session_ : nullptr; }

  /// Brings state and scene to `now`; true when they changed.
  Result<bool> update(SteadyTime now);

  /// Where the picture is taken from: a named camera, until the mouse takes hold.
  CameraView cameraView();
  const std::string& cameraName() const { return camera_name_; }  ///< empty: the turntable
  void useCamera(const std::string& name);
  /// The turntable, standing where the present camera stands.
  Turntable& holdCamera();
  /// Shows `points`, all that is visible, from the present direction.
  void fit(const std::vector<Vec3>& points, int width, int height);
  /// Names of the cell's cameras and of the session's views.
  std::vector<std::string> cameraNames() const;

  /// False for a PATH that is none.
  bool setVisible(const std::string& path, bool visible);
  /// What was chosen for the PATH; empty when nothing was.
  std::optional<bool> chosenVisibility(const std::string& path) const;

  std::string selected_device;
  bool panels_shown = true;
  std::string complaint;  ///< one sentence to show; empty: none

 private:
  ViewModel() = default;
  Status updateChoice();

  std::unique_ptr<Cell> cell_;  // does not move: the renderer borrows it
  std::optional<Timeline> session_;
  std::optional<LiveFeed> feed_;
  std::unique_ptr<LiveSnapshot> live_;
  std::optional<Transport> transport_;
  std::optional<LogTime> shown_;
  SessionState nothing_said_;
  const SessionState* state_ = &nothing_said_;
  PosedScene scene_;
  std::vector<Event> events_;
  std::set<std::string> hidden_, shown_paths_;
  ViewChoice choice_;
  std::string camera_name_;
  Turntable turntable_;
};

}  // namespace rocinante
