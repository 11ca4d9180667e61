#pragma once

#include "core/cell/posed_scene.h"
#include "viewer/view/frame_extras.h"

namespace rocinante {

/// FrameExtras::limits of a scene posed from `state`: by device, by link. A link's joint counts
/// when it is revolute or prismatic and has a range; mimic joints too.
std::vector<std::vector<LimitLevel>> limitLevels(const PosedScene& scene,
                                                 const SessionState& state);

/// Of one value: near within 5 % of the range of an end, beyond past an end by more than a
/// millionth of the range (values come rounded), and beyond when it is no number.
LimitLevel limitLevel(const JointLimits& limits, double value);

}  // namespace rocinante
