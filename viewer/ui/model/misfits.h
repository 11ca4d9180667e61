#pragma once

#include <string>
#include <vector>

#include "core/cell/posed_scene.h"

namespace rocinante {

/// Something that was said and that the cell has no place for, so that nothing of it is seen.
struct Misfit {
  std::string device;
  std::string what;  ///< "is no device of the cell: did you mean `arm`?"
};

/// Of the devices that were spoken of, one each at most, by name. Devices that wait for their `add`
/// and those that were removed are none. Pure; `rocinante check` judges far more.
std::vector<Misfit> misfits(const Cell& cell, const PosedScene& scene, const SessionState& state);

}  // namespace rocinante
