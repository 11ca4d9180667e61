#pragma once

#include <vector>

#include "core/cell/cell.h"
#include "core/report/finding.h"

namespace rocinante {

/// The differences between the cell that a log carries and the cell that it is viewed with, each
/// with its effect on a replay. Numbers that differ only by rounding and unit conversion are the
/// same; geometry is the same when it decodes to the same triangles. Opens textures of both cells,
/// whose files must still be there.
Findings modelDrift(const Cell& recorded, const Cell& given);

}  // namespace rocinante
