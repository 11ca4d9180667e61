#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/cell/posed_scene.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// Devices of the cell that the user moved, with undo. What is drawn shows them; neither log nor
/// cell changes, and packets outrank them. Poses are in the space of the cell's own: the world, or
/// the link that carries the device. Main thread.
class DeviceMoves {
 public:
  static constexpr std::size_t kMostSteps = 1000;  ///< then the oldest cannot be undone
  using Poses = std::map<std::string, Pose, std::less<>>;

  const Poses& poses() const { return poses_; }
  const Pose* find(std::string_view device) const;

  /// Puts a device there, or back to where the cell has it; one step to undo.
  void put(const std::string& device, const std::optional<Pose>& pose);
  /// The same while the mouse holds it: all of them are one step, until settle().
  void hold(const std::string& device, const std::optional<Pose>& pose);
  void settle();
  /// Undoes or does again the last step: the device; empty when there is none.
  std::optional<std::string> undo();
  std::optional<std::string> redo();
  bool canUndo() const { return !done_.empty() || held_.has_value(); }
  bool canRedo() const { return !undone_.empty(); }

  /// The cell's file has the device there from now on.
  void saved(const std::string& device, const Pose& there);
  /// Where the cell's file has it, as far as it was saved: null otherwise.
  const Pose* findSaved(std::string_view device) const;
  /// Devices that are not where the cell's file has them, in order of their names. One that was
  /// saved elsewhere and put back is among them.
  std::vector<std::string> unsaved() const;

  /// Something changed since the last call.
  bool takeChanged() { return std::exchange(changed_, false); }
  /// The state to draw: `shown` itself, or one of this object's that has the devices where they
  /// were moved, which stays until the next call.
  const SessionState* over(const SessionState& shown, const Cell& cell, LogTime moment);

 private:
  struct Step {
    std::string device;
    std::optional<Pose> before, after;
  };
  std::optional<Pose> poseNow(const std::string& device) const;
  void set(const std::string& device, const std::optional<Pose>& pose);
  std::optional<std::string> apply(std::vector<Step>& from, std::vector<Step>& to, bool back);

  Poses poses_, saved_;
  std::vector<Step> done_, undone_;
  std::optional<Step> held_;  ///< its `after` is what is shown
  bool changed_ = false;
  std::unique_ptr<SessionState> state_;  // does not move: the scene borrows from it
};

}  // namespace rocinante
