#pragma once

#include "core/cell/cell.h"
#include "core/report/finding.h"

namespace rocinante {

/// Limits of the cell's models that are valid and hardly meant: angles in degrees, which no value
/// in radians exceeds, and speeds of 0.
void judgeModelUnits(const Cell& cell, Findings& findings);

}  // namespace rocinante
