#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/cell/cell.h"
#include "core/packet/session_state.h"
#include "golden/why/pixel_blame.h"

namespace rocinante {

/// A moment of a session, as its cell poses it. Borrowed.
struct Moment {
  const Cell& cell;
  const SessionState& state;
};

/// Something that is not the same in two sessions at one moment.
struct StateChange {
  std::string item;  ///< "arm/shoulder", "arm", "drawing planner/goal", "camera overview"
  std::string text;  ///< "arm/shoulder: 23.61° -> 24.12°"
  /// How much a joint or a base moved, in rad or in m; empty for what has no measure.
  std::optional<double> amount;
  bool is_angle = false;
};

/// What differs, devices in the order of the scene, then drawings, then the camera named (empty:
/// none). Joint values as the model takes them: mimics follow, what no model knows is left out.
std::vector<StateChange> stateChanges(const Moment& golden, const Moment& frame,
                                      const std::string& camera);

/// Links that stand elsewhere in the world, or whose visuals do, or that are shown in one only.
MovedLinks movedLinks(const Moment& golden, const Moment& frame);

}  // namespace rocinante
