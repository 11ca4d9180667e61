#pragma once

#include <string>
#include <vector>

#include "golden/run/motion_judge.h"

namespace rocinante {

/// Judges something that is stated rather than moved: visibility, colour, presence, a carrier, a
/// drawing. It must be, at each time, as in one of the accepted sessions about then.
void judgeFact(const RunGrids& grids, const std::string& fact, std::vector<RunFinding>& findings);

}  // namespace rocinante
