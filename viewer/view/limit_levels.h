#pragma once

#include "core/cell/posed_scene.h"
#include "viewer/view/frame_extras.h"

namespace rocinante {

/// FrameExtras::limits of a scene posed from `state`: by device, by link. A link's joint counts
/// when it is revolute or prismatic and has a range; mimic joints too.
std::vector<std::vector<LimitLevel>> limitLevels(const PosedScene& scene,
                                                 const SessionState& state);

/// The level of one value: near within 5 % of the range from an end; beyond when past an end by
/// more than a millionth of the range (values are rounded), or NaN.
LimitLevel limitLevel(const JointLimits& limits, double value);

}  // namespace rocinante
