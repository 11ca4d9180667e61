#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/cell/cell.h"
#include "core/packet/session_state.h"
#include "golden/why/pixel_blame.h"

namespace rocinante {

/// A cell and the state of a session at one moment. Borrowed.
struct Moment {
  const Cell& cell;
  const SessionState& state;
};

/// A difference of two sessions at one moment.
struct StateChange {
  std::string item;  ///< "arm/shoulder", "arm", "drawing planner/goal", "camera overview"
  std::string text;  ///< "arm/shoulder: 23.61° -> 24.12°"
  /// Movement of a joint or base in rad or m; empty for other changes.
  std::optional<double> amount;
  bool is_angle = false;
  std::string common{};  ///< `text` without figures; empty: it has none
};

/// The differences: devices in scene order, then drawings, then the named camera (empty: none).
/// Joint values as applied to the model: mimic joints follow, unknown joints are left out.
std::vector<StateChange> stateChanges(const Moment& golden, const Moment& frame,
                                      const std::string& camera);

/// Links whose world pose or visuals differ.
MovedLinks movedLinks(const Moment& golden, const Moment& frame);

}  // namespace rocinante
