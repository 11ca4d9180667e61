#pragma once

#include <string>
#include <vector>

#include "golden/run/motion_judge.h"

namespace rocinante {

/// Judges something that is stated rather than moved: visibility, colour, presence, a carrier, a
/// drawing. It must be, at each time, as in one of the accepted sessions about then, and what all
/// of them have must be in the run about then.
void judgeFact(const RunTimes& times, const std::string& fact, std::vector<RunFinding>& findings);

}  // namespace rocinante
