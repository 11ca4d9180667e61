#pragma once

#include <vector>

#include "core/cell/cell.h"
#include "core/report/finding.h"

namespace rocinante {

/// The differences between the robot that a recording describes (a cell of one device) and the
/// devices of the given cell that it means: those whose model has its name, or the only device.
/// None when it means no device. `has_meshes`: the description's files were found; otherwise its
/// geometry is not compared. Textures as modelDrift().
Findings descriptionDrift(const Cell& described, bool has_meshes, const Cell& given);

/// The differences between the cell that a log carries and the cell that it is viewed with, each
/// with its effect on a replay. Numbers that differ only by rounding and unit conversion are the
/// same; geometry is the same when it decodes to the same triangles. Opens textures of both cells,
/// whose files must still be there.
Findings modelDrift(const Cell& recorded, const Cell& given);

}  // namespace rocinante
