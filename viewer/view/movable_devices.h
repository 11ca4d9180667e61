#pragma once

#include <set>
#include <string>

#include "core/cell/cell.h"
#include "core/cell/posed_scene.h"

namespace rocinante {

using DeviceNames = std::set<std::string, std::less<>>;

/// Adds to `names` the devices of `scene` that can move, by docs/cell-format.md, section "Built
/// in": those with a joint that is not fixed, those moved by a [[source]], those whose pose differs
/// from `at_rest` (the cell without packets) or that are not in it, and those that the cell puts on
/// one of these. Pure.
void addMovableDevices(const Cell& cell, const PosedScene& at_rest, const PosedScene& scene,
                       DeviceNames& names);

}  // namespace rocinante
