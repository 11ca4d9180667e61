#pragma once

#include "core/cell/cell.h"
#include "core/report/finding.h"

namespace rocinante {

/// The differences between the robot that a recording describes (a cell of one device) and the
/// devices of the given cell that it means: those whose model has its name, or the only device.
/// None when it means no device. `has_meshes`: the description's files were found; otherwise its
/// geometry is not compared. Textures as modelDrift().
Findings descriptionDrift(const Cell& described, bool has_meshes, const Cell& given);

}  // namespace rocinante
