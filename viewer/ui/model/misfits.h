#pragma once

#include <string>
#include <vector>

#include "core/cell/posed_scene.h"

namespace rocinante {

/// Received data that does not fit the cell, so that it has no effect.
struct Misfit {
  std::string device;
  std::string what;  ///< "is not a device of the cell ...: did you mean `arm`?"
};

/// At most one per device, by name. Devices that wait for their `add` and removed ones do not
/// count. Pure; `rocinante check` checks far more.
std::vector<Misfit> mismatchedDevices(const Cell& cell, const PosedScene& scene,
                                      const SessionState& state);

/// Why a session that ends with this state is none of the cell: no packet came, or no device that
/// is moved in it fits. A sentence's rest ("has no packets"); empty: it may be one. Pure.
std::string whyNoSession(const Cell& cell, const SessionState& last);

}  // namespace rocinante
