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
std::vector<Misfit> misfits(const Cell& cell, const PosedScene& scene, const SessionState& state);

}  // namespace rocinante
