#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>

#include "core/behaviour/session_track.h"
#include "core/kinematics/model.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// LeftOut::kind of a device that the cell has and whose model it has not.
inline constexpr const char* kUnreadModel = "model";

/// Puts into a track's account what packets state and no device takes, each once, since packets
/// restate it, and what could not be read.
class UnfitValues {
 public:
  /// `track` is borrowed.
  explicit UnfitValues(SessionTrack& track) : track_(track) {}

  /// False when the model takes none of the joint values that are stated.
  bool takesValues(const std::string& device, const Model& model, const DeviceState& state);
  void leaveOut(const char* kind, std::string name, std::string reason, LogTime first);

  using CountsBySource = std::map<std::string, SourceCounts, std::less<>>;
  /// Lines with a fault, and packets that came behind newer ones; `before`: before the session.
  void leaveOutUnread(const CountsBySource& counts, const CountsBySource& before);

 private:
  SessionTrack& track_;
  std::set<std::string> known_;
};

}  // namespace rocinante
