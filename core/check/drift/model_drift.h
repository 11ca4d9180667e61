#pragma once

#include <vector>

#include "core/cell/cell.h"
#include "core/check/rules/finding.h"

namespace rocinante {

/// What differs between the cell that a log carries and the cell that it is looked at with, each
/// with a sentence on what a replay would show wrong. Numbers that differ by what rounding and
/// unit conversion do are the same; geometry is the same when it decodes to the same triangles.
/// Opens textures of both cells, whose files must still be there.
std::vector<Finding> modelDrift(const Cell& recorded, const Cell& given);

}  // namespace rocinante
