#pragma once

#include <string>
#include <vector>

#include "golden/run/motion_judge.h"

namespace rocinante {

/// Judges how often packets state a device, in stretches of a second.
void judgeRate(const RunTimes& times, const std::string& device, std::vector<RunFinding>& findings);

}  // namespace rocinante
