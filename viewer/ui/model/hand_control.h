#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "core/cell/posed_scene.h"
#include "core/packet/session_state.h"
#include "viewer/ui/live/hand_drive.h"
#include "viewer/view/hand_joints.h"
#include "viewer/view/units.h"

namespace rocinante {

/// What joint values set by hand do (docs/decisions/018).
enum class HandUse {
  drawn,  ///< no log, or one that is paused ("what if")
  sent,   ///< live and driving: the picture shows what packets say
  none,   ///< live and not driving: packets alone move devices
};

/// A value that is being typed in place of its slider.
struct ValueEdit {
  std::string device, value_name;
  std::array<char, 48> text{};  ///< NUL-terminated
  bool begun = false;           ///< it has the keyboard
  bool invalid = false;         ///< what was entered is not a value
};

/// Joints moved by hand: the window's sliders, and the source that sends what they say. Main
/// thread.
class HandControl {
 public:
  const HandJoints& joints() const { return joints_; }
  HandUse use() const { return use_; }
  /// The drawn state has values by hand.
  bool drawn() const { return what_if_ != nullptr; }

  /// Replaces all values: those of `--joints`.
  void take(HandJoints joints);
  /// Sets one value, in radians or metres. bad_argument for one that the device has not, and when
  /// values by hand do nothing. While driving it is sent, and no other joint is.
  Status set(const PosedDevice& device, const std::string& value_name, double value);
  /// All joints of the device, positional.
  Status setAll(const PosedDevice& device, std::span<const double> values);
  /// Gives values back to packets and model; while driving they are not sent any more.
  void reset(const std::string& device, const std::string& value_name);
  void reset(const std::string& device);
  void resetAll();

  /// Called for each update of the window, before over(). `live`: now is shown. `playing`: the log
  /// moves the picture, which ends driving and gives joints back.
  void setSituation(bool live, bool playing);
  /// Something changed since the last call.
  bool takeChanged() { return std::exchange(changed_, false); }
  /// The state to draw: `received`, or with values by hand one of this object's, which stays until
  /// the next call.
  const SessionState* over(const SessionState& received, LogTime moment);

  /// Enters the mode in which what the hand moves from now on is sent (docs/decisions/036).
  /// Replaces a present destination.
  Status drive(const std::string& endpoint, const std::string& source);
  void drive(HandDrive opened);
  /// The same again, to where it was last; bad_argument when it never was.
  Status driveAgain();
  /// Ends the mode: nothing is sent any more.
  void stopDriving();
  const HandDrive* driving() const { return drive_ ? &*drive_ : nullptr; }
  /// The mode was entered since the last call: the window goes to now, or pauses its log.
  bool takeEntered() { return std::exchange(entered_, false); }
  /// Sends what is due.
  void sendDue(SteadyTime now, WallTime wall);

  Units units;
  std::optional<ValueEdit> edit;
  std::optional<double> before_press;      ///< of the pressed slider, if it was set by hand
  double grabbed_at = 0;                   ///< part of the slider between its thumb and the mouse
  std::array<char, 128> drive_endpoint{};  ///< being typed; NUL-terminated
  std::array<char, 64> drive_source{};     ///< the same
  std::string trouble;                     ///< why driving did not begin; a sentence

 private:
  HandJoints joints_;
  HandUse use_ = HandUse::drawn;
  bool changed_ = false, entered_ = false;
  std::string last_endpoint_, last_source_;
  std::unique_ptr<SessionState> what_if_;  // does not move: the scene borrows from it
  std::optional<HandDrive> drive_;
};

}  // namespace rocinante
