#pragma once

#include <array>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/cell/cell.h"
#include "core/cell/posed_scene.h"
#include "core/cell/scene_pose_cache.h"
#include "core/session/timeline.h"
#include "viewer/ui/live/live_feed.h"
#include "viewer/ui/live/live_reason.h"
#include "viewer/ui/live/source_rows.h"
#include "viewer/ui/model/misfits.h"
#include "viewer/ui/model/timeline_cursor.h"
#include "viewer/ui/model/turntable.h"
#include "viewer/view/frame_extras.h"
#include "viewer/view/known_names.h"
#include "viewer/view/render_style.h"
#include "viewer/view/trail_finder.h"
#include "viewer/view/view_choice.h"

namespace rocinante {

/// An inset and whether it is shown.
struct InsetChoice {
  CellInset inset;
  bool shown = true;
};

/// The selected object.
struct Selection {
  std::string device;  ///< empty: nothing
  std::string link;    ///< empty: the device as a whole
  bool operator==(const Selection&) const = default;
  /// The PATH, as in packets and styles.
  std::string path() const;
};

/// The state behind the panels: what the window shows and what the user chose. Needs no window. Not
/// thread-safe.
class ViewModel {
 public:
  /// For the cell alone, a recorded session or a live one: at most one of `session` and `feed`.
  /// not_found for an unknown PATH (KnownNames).
  static Result<ViewModel> make(Cell cell, std::optional<Timeline> session,
                                std::optional<LiveFeed> feed, std::vector<std::string> hide,
                                std::vector<std::string> show);

  const Cell& cell() const { return *cell_; }
  /// Checks PATHs and cameras' names.
  KnownNames& names() { return *names_; }
  const SessionState& state() const { return *state_; }
  const PosedScene& scene() const { return scene_; }
  const ViewChoice& choice() const { return choice_; }

  /// Null without a log.
  TimelineCursor* cursor() { return cursor_ ? &*cursor_ : nullptr; }
  LogTime origin() const { return session_ ? session_->origin() : LogTime{}; }
  /// The shown moment as of the last update(); the newest datagram's in live mode.
  LogTime shownTime() const { return shown_.value_or(LogTime{}); }
  const std::vector<Event>& events() const { return events_; }
  /// The nearest event after or before a moment, or null.
  const Event* eventBeside(LogTime moment, bool after) const;
  /// The time of the datagram after or before the shown moment, if any.
  Result<std::optional<LogTime>> packetBeside(bool after);
  /// Datagrams that the recorder counted as lost.
  std::uint64_t recordedLosses() const { return recorded_losses_; }
  /// Adds a mark beside the log at the shown moment; it then appears in events().
  Status addMark(const std::string& text);
  /// Null when not live or before the first datagram.
  const LiveSnapshot* live() const { return live_.get(); }
  /// The sources of a live session and those that the cell expects; valid until update().
  std::vector<SourceRow> sourceRows(SteadyTime now) const;
  bool isLive() const { return feed_.has_value(); }
  const LiveFeed& feed() const { return *feed_; }
  /// Why nothing moves in a live session; empty otherwise.
  std::optional<LiveReason> liveReason(SteadyTime now) const;
  /// Received data that does not fit the cell; in a live session at most half a second old.
  const std::vector<Misfit>& misfits() const { return misfits_; }
  /// Damage of the log that affects the picture, and any picture shown so far.
  const StateDamage& damage() const { return damage_; }
  const StateDamage& seenDamage() const { return seen_damage_; }
  Timeline* session() { return session_ ? &*session_ : nullptr; }
  const Timeline* session() const { return session_ ? &*session_ : nullptr; }

  /// Updates state and scene to `now`; true when they changed.
  Result<bool> update(SteadyTime now);

  /// The picture's camera: a named one, until the mouse moves it.
  CameraView cameraView();
  const std::string& cameraName() const { return camera_name_; }  ///< empty: the turntable
  void useCamera(const std::string& name);
  /// Selects the cell's first camera, or without one the initial turntable, not fitted yet.
  void resetCamera();
  /// The turntable, placed at the present camera.
  Turntable& holdCamera();
  /// Shows `points`, everything visible, from the present direction.
  void fit(const std::vector<Vec3>& points, int width, int height);
  /// Names of the cell's cameras and of the session's views.
  std::vector<std::string> cameraNames() const;

  /// Hides, shows or (empty) resets to packets and cell. False for an invalid PATH.
  bool setVisible(const std::string& path, std::optional<bool> visible);
  /// The user's choice for the PATH, if any.
  std::optional<bool> chosenVisibility(const std::string& path) const;
  /// Visibility by packets, else by the cell.
  bool layerVisibleByDefault(const CellLayer& layer) const;
  std::vector<std::string> hiddenPaths() const { return {hidden_.begin(), hidden_.end()}; }
  std::vector<std::string> shownPaths() const { return {shown_paths_.begin(), shown_paths_.end()}; }

  /// All optional looks, as changed by panels and keys. frameStyle() adds the outline of the
  /// selection.
  const RenderStyle& style() const { return style_; }
  void setStyle(const RenderStyle& style);
  RenderStyle frameStyle() const;
  /// Data for limits and trails of the style, for scene().
  const FrameExtras& extras() const { return extras_; }

  std::vector<InsetChoice> insets;
  Selection selected;
  bool outline_selected = true;
  bool panels_shown = true;
  bool help_shown = false;
  std::array<char, 256> mark_text{};     ///< being typed; NUL-terminated
  std::array<char, 64> device_filter{};  ///< part of the listed names; NUL-terminated
  std::array<char, 64> source_filter{};  ///< the same for sources
  std::array<char, 64> event_filter{};   ///< the same for events
  std::set<std::string> open_devices;    ///< whose links are listed
  std::string complaint;                 ///< one sentence to show; empty: none
  std::vector<std::string> doubts;       ///< doubts about written files, printed at the end

 private:
  ViewModel() = default;
  Status updateChoice();
  Status findState(LogTime moment);

  std::unique_ptr<Cell> cell_;       // does not move: the renderer borrows it
  std::optional<KnownNames> names_;  // of *cell_
  std::optional<Timeline> session_;
  std::optional<LiveFeed> feed_;
  std::unique_ptr<LiveSnapshot> live_;
  std::optional<SteadyTime> live_since_, last_arrival_, live_at_;
  std::optional<TimelineCursor> cursor_;
  std::optional<LogReader> walker_;  // over datagrams; made on first use
  std::uint64_t recorded_losses_ = 0;
  StateDamage damage_, seen_damage_;
  std::optional<LogTime> shown_;
  SessionState nothing_said_;
  const SessionState* state_ = &nothing_said_;
  std::optional<ScenePoseCache> poses_;  // of *cell_
  PosedScene scene_;
  RenderStyle style_;
  bool style_changed_ = false;
  std::optional<TrailFinder> trail_finder_;
  FrameExtras extras_;
  std::vector<Misfit> misfits_;
  std::optional<SteadyTime> misfits_at_;
  std::vector<Event> events_;
  std::set<std::string> hidden_, shown_paths_;
  ViewChoice choice_;
  std::string camera_name_;
  Turntable turntable_;
};

}  // namespace rocinante
