#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/cell/cell.h"
#include "core/cell/posed_scene.h"
#include "core/session/timeline.h"
#include "viewer/shown/turntable.h"
#include "viewer/ui/live/live_feed.h"
#include "viewer/ui/live/live_reason.h"
#include "viewer/ui/live/other_windows.h"
#include "viewer/ui/live/source_rows.h"
#include "viewer/ui/model/device_moves.h"
#include "viewer/ui/model/hand_control.h"
#include "viewer/ui/model/misfits.h"
#include "viewer/ui/model/packet_search.h"
#include "viewer/ui/model/publishing.h"
#include "viewer/ui/model/selection.h"
#include "viewer/ui/model/timeline_cursor.h"
#include "viewer/ui/model/viewer_state.h"
#include "viewer/ui/study/endpoint_survey.h"
#include "viewer/ui/study/findings_study.h"
#include "viewer/ui/study/log_study.h"
#include "viewer/ui/study/nearest_study.h"
#include "viewer/ui/study/parting_study.h"
#include "viewer/view/beside_session.h"
#include "viewer/view/frame_extras.h"
#include "viewer/view/inset_layout.h"
#include "viewer/view/known_names.h"
#include "viewer/view/render_style.h"
#include "viewer/view/scene_poser.h"
#include "viewer/view/view_choice.h"

namespace rocinante {

/// The state behind the panels: what the window shows and what the user chose. Needs no window. Not
/// thread-safe.
class ViewModel {
 public:
  /// For the cell alone, a recorded session, which may still grow, or a live one: at most one of
  /// `session` and `feed`.
  /// not_found for an unknown PATH (KnownNames).
  static Result<ViewModel> make(Cell cell, std::optional<Timeline> session,
                                std::optional<LiveFeed> feed, std::vector<std::string> hide,
                                std::vector<std::string> show);

  /// Shows another log of the cell beside the session, as clear ghosts, in place of one that is
  /// there. bad_argument without a session; alignBeside() says what `align` is. What is shown stays
  /// as it is when it fails.
  Status showBeside(Timeline beside, std::string_view align);
  /// There is no session beside any more, nor what was chosen for its ghosts.
  void endBeside();

  const Cell& cell() const { return *cell_; }
  /// Checks PATHs and cameras' names.
  KnownNames& names() { return *names_; }
  /// The drawn state: received(), or with joints and devices moved by hand.
  const SessionState& state() const { return *state_; }
  const SessionState& received() const { return *received_; }
  const PosedScene& scene() const { return scene_; }
  const ViewChoice& choice() const { return choice_; }

  /// Null without a log; of a live session, before anything is kept.
  TimelineCursor* cursor() { return cursor_ ? &*cursor_ : nullptr; }
  const TimelineCursor* cursor() const { return cursor_ ? &*cursor_ : nullptr; }
  LogTime origin() const { return session_ ? session_->origin() : LogTime{}; }
  /// The shown moment as of the last update(); the newest datagram's in live mode.
  LogTime shownTime() const { return shown_.value_or(LogTime{}); }
  const std::vector<Event>& events() const { return events_; }
  /// parseMoment() in the shown session.
  Result<LogTime> momentNamed(const std::string& text);
  /// The nearest event after or before a moment, or null.
  const Event* eventBeside(LogTime moment, bool after) const;
  /// The time of the datagram after or before the shown moment, if any.
  Result<std::optional<LogTime>> packetBeside(bool after);
  /// Datagrams that the recorder counted as lost.
  std::uint64_t recordedLosses() const { return recorded_losses_; }
  /// Adds a mark beside the log at the shown moment; it then appears in events().
  Status addMark(const std::string& text);
  /// Null when not live or before the first datagram.
  const LiveSnapshot* live() const { return heard_ ? live_.get() : nullptr; }
  /// What becomes of a live session's kept log, for the panels; empty when there is nothing to say.
  const std::string& keepingTrouble() const { return keeping_trouble_; }
  /// Goes to now and stays there; false when the session does not go on.
  bool goToNow();
  /// Now is shown: a live session, or the end of a log that is being written.
  bool showsNow() const { return feed_ && !cursor_ ? true : cursor_ && cursor_->following(); }
  /// A log that has the shown moment whole, for other programs. Of a kept log, its piece, once that
  /// is finished: waits for it, two seconds at most.
  Result<std::filesystem::path> logOfShownMoment();
  /// The sources of a live session and those that the cell expects; valid until update().
  std::vector<SourceRow> sourceRows(SteadyTime now) const;
  bool isLive() const { return feed_.has_value(); }
  /// More is still being written to the session.
  bool isGrowing() const { return log_grows_; }
  const LiveFeed& feed() const { return *feed_; }
  LiveFeed& feed() { return *feed_; }
  /// Goes on with the live session of another model, with what that has heard and kept. That one is
  /// only to be destroyed then. This one has neither a session nor one that is live.
  void takeLive(ViewModel& from);
  /// Why nothing moves in a live session; empty otherwise.
  std::optional<Finding> liveReason(SteadyTime now) const;
  /// Since the last datagram of a live session, or since it began; empty: it is not live.
  std::optional<Nanoseconds> liveSilence(SteadyTime now) const;
  /// Received data that does not fit the cell; in a live session at most half a second old.
  const std::vector<Misfit>& mismatchedDevices() const { return mismatched_; }
  /// Damage of the log that affects the picture, and any picture shown so far.
  const StateDamage& damage() const { return damage_; }
  const StateDamage& seenDamage() const { return seen_damage_; }
  Timeline* session() { return session_ ? &*session_ : nullptr; }
  const Timeline* session() const { return session_ ? &*session_ : nullptr; }

  /// The session beside; null without one. It may be out of sight (beside_shown).
  const BesideSession* beside() const { return beside_ ? &*beside_ : nullptr; }
  /// Where the two are apart, looked for in the background from the first call on; null without a
  /// session beside.
  const PartingStudy* partings();
  /// The log beside as functions of its time, as study(); null without one.
  LogStudy* studyBeside();

  /// The log as functions of time, read in the background from the first call on; null without one,
  /// and while `study_delayed`.
  LogStudy* study();
  /// The log as `rocinante check` judges it, in the background once study() has read the log; null
  /// before that, without a log, and while `findings_wanted` is false.
  const FindingsStudy* findings();
  /// The distance of the selected device or link from the reference, or from the nearest other
  /// device, as it was last measured in the background: null while `nearest_wanted` is false,
  /// without a selection and before the first answer. It may be of an earlier moment.
  const NearestFound* nearest() const { return nearest_found_ ? &*nearest_found_ : nullptr; }

  /// Listens at the usual endpoints for a moment, in the background; nothing while it does.
  void listenAround();
  /// What it heard; null before the first listenAround().
  const EndpointSurvey* survey() const { return survey_.get(); }

  /// The background has something new to show.
  bool hasStudyNews() const;
  /// The background is about to have something new: the window should look soon.
  bool isStudyBusy() const;

  /// Updates state and scene to `now`; true when they changed.
  Result<bool> update(SteadyTime now);

  /// What the device's panel shows: the selection; without one, and without packets, the first
  /// device that has joints.
  Selection inspected() const;
  /// HandControl::set for a device by name; pauses the log, and leaves a live session at now.
  Status setByHand(const std::string& device, const std::string& value_name, double value,
                   SteadyTime now);
  /// The same by HandControl::setAll.
  Status setByHand(const std::string& device, std::span<const double> values, SteadyTime now);

  /// The pose of a device that can be moved by hand, in the space that the cell says it in.
  /// bad_argument: it is not of the cell, not there now, or packets say where it is.
  Result<Pose> movablePose(const std::string& device) const;

  /// The picture's camera: a named one, until the mouse moves it.
  CameraView cameraView();
  const std::string& cameraName() const { return camera_name_; }  ///< empty: the turntable
  void useCamera(const std::string& name);
  /// A built-in camera, which has this view until another is used.
  void useBuiltInCamera(const std::string& name, const CameraView& view);
  bool hasBuiltInCamera() const { return has_built_in_ && !camera_name_.empty(); }
  /// Adds a camera to those of the cell, which is the shown one's from now on.
  void addCamera(CellCamera camera);
  /// Selects the cell's first camera, or without one the initial turntable, not fitted yet.
  void resetCamera();
  /// The turntable, placed at the present camera.
  Turntable& holdCamera();
  /// Shows `points`, everything visible, from the present direction.
  void fit(const std::vector<Vec3>& points, int width, int height);
  /// The views that sources of the session publish, those of other windows among them.
  std::vector<std::string> viewsOfOthers() const;
  /// The one that is shown; empty: none.
  std::string watched() const;
  /// Other windows, as far as they speak.
  const OtherWindows& others() const { return others_; }
  /// Stays where the watched one looks from now.
  void stopWatching();
  /// Names of the cell's cameras and of the session's views.
  std::vector<std::string> cameraNames() const;

  /// Hides, shows or (empty) resets to packets and cell. False for an invalid PATH.
  bool setVisible(const std::string& path, std::optional<bool> visible);
  /// Hides every device but that of the PATH, in place of what was chosen before. False when there
  /// is no such device.
  bool showOnly(const std::string& path);
  /// The user's choice for the PATH, if any.
  std::optional<bool> chosenVisibility(const std::string& path) const;
  /// Visibility by packets, else by the cell.
  bool layerVisibleByDefault(const CellLayer& layer) const;
  std::vector<std::string> hiddenPaths() const { return {hidden_.begin(), hidden_.end()}; }
  std::vector<std::string> shownPaths() const { return {shown_paths_.begin(), shown_paths_.end()}; }

  /// All optional looks, as changed by panels and keys. frameStyle() adds the outline of the
  /// selection, and what is being picked.
  const RenderStyle& style() const { return style_; }
  void setStyle(const RenderStyle& style);
  /// Shadows and contact, as looks of the window's own choice, until the user chooses one of them;
  /// and the camera's cone in maps.
  void useLooksByDefault();
  /// Ends them: they took far too long.
  void dropLooksByDefault();
  /// Shadows and contact are the window's choice, which a frame may leave out to be drawn in time.
  bool hasLooksByDefault() const { return looks_by_default_; }
  RenderStyle frameStyle() const;
  /// A click on a surface while a distance is picked.
  void pickPoint(const Selection& link, const Vec3& point);
  /// The camera moves with the selection from now on, or no longer.
  void toggleFollowing();
  /// What the camera moves with; empty: nothing.
  const Selection& followed() const { return followed_; }

  /// Data for limits and trails of the style, for scene().
  const FrameExtras& extras() const { return extras_; }

  ViewerState viewer;
  Selection selected;
  HandControl hand;
  DeviceMoves moves;
  Publishing publishing;
  std::optional<BackdropChoice> backdrop;  ///< empty: there is none
  bool beside_shown = true;                ///< the ghosts and curves of the session beside
  bool study_waits = false;                ///< under a script, for identical screenshots
  bool study_delayed = false;              ///< until there is a first picture, which has both cores

 private:
  ViewModel() = default;
  Status updateChoice();
  void dropBesideStudies();
  Status findState(LogTime moment);
  /// Makes scene_ of state_, which is of this moment, with the ghosts beside.
  Status pose(LogTime moment);
  void follow();
  /// Shows what is driven: now, or the log's moment at which it was begun.
  void enterDriving(SteadyTime now);
  Status setByHand(const std::string& device, const std::function<Status(const PosedDevice&)>& set,
                   SteadyTime now);
  /// Asks for the nearest distance of what is shown, and takes the last answer; true when its line
  /// in the picture changed.
  bool lookForNearest();
  /// Trails up to `moment`, as far as the log goes.
  Status findTrails(LogTime moment);
  // Of a growing session (view_model_growing.cpp).

  /// The clock of the feed, which is not a script's: only differences count.
  SteadyTime feedTime(SteadyTime now) const;
  /// Takes what came; true when it changes the picture.
  bool hear(SteadyTime now);
  /// Looks at the growing log, now and then; true when the shown state may have become known.
  bool watchLog(SteadyTime now);
  bool openKeptLog();
  void takeOverLog();
  void loseLog(const Error& error);
  /// From now on `state` is what was received. The scene refers to drawings of the one before,
  /// which may be gone: it is posed anew before anything is drawn.
  void receive(const SessionState& state);
  /// Shows the moment of the log, or what was live then while the log does not have it yet.
  Status showMoment(LogTime moment);

  std::unique_ptr<Cell> cell_;       // does not move: the renderer borrows it
  std::optional<KnownNames> names_;  // of *cell_
  std::optional<Timeline> session_;
  std::optional<LiveFeed> feed_;
  std::unique_ptr<LiveSnapshot> live_;
  bool heard_ = false;  ///< something has come
  OtherWindows others_;
  /// The live state of the moment at which the user left now: the log has it a little later.
  struct LeftNow {
    LogTime time;
    SessionState state;
  };
  std::optional<LeftNow> left_now_;
  bool was_following_ = false;
  bool log_grows_ = false;
  std::optional<SteadyTime> log_watched_;
  std::string keeping_trouble_;
  std::optional<SteadyTime> live_since_, last_arrival_, live_at_;
  std::optional<TimelineCursor> cursor_;
  std::optional<LogReader> walker_;  // over datagrams; made on first use
  std::uint64_t recorded_losses_ = 0;
  StateDamage damage_, seen_damage_;
  std::optional<LogTime> shown_;
  SessionState empty_state_;
  const SessionState* received_ = &empty_state_;
  bool scene_is_old_ = false;  ///< not posed of what is received
  const SessionState* state_ = &empty_state_;
  std::optional<ScenePoser> poser_;  // of *cell_
  PosedScene scene_;
  RenderStyle style_;
  bool style_changed_ = false;
  bool looks_by_default_ = false;
  FrameExtras extras_;
  std::vector<Misfit> mismatched_;
  std::optional<SteadyTime> mismatched_at_;
  std::vector<Event> events_;
  std::optional<BesideSession> beside_;  // borrows *cell_
  bool beside_was_shown_ = true;
  Selection followed_;
  std::unique_ptr<PartingStudy> partings_;          // borrows *cell_
  std::unique_ptr<LogStudy> study_, study_beside_;  // borrow *cell_
  std::unique_ptr<FindingsStudy> judged_;           // borrows *cell_
  bool judged_seen_ = false;
  std::unique_ptr<NearestStudy> nearest_;  // borrows *cell_
  std::unique_ptr<EndpointSurvey> survey_;
  std::optional<NearestFound> nearest_found_;
  std::optional<NearestQuery> nearest_asked_;
  bool nearest_is_old_ = false;  ///< what is shown has changed since it was asked
  std::set<std::string> hidden_, shown_paths_;
  ViewChoice choice_;
  std::string camera_name_;
  std::optional<CameraView> named_view_;  ///< the last one of that name
  bool has_built_in_ = false;             ///< that is the one of a built-in camera
  Turntable turntable_;
  std::optional<Vec3> followed_at_;
};

}  // namespace rocinante
