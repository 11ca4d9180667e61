#pragma once

#include <string>
#include <vector>

#include "core/packet/session_state.h"

namespace rocinante {

/// Everything of a drawing but its points: kind, colour, size, carrier, text, number of points.
std::string drawingStyle(const Drawing& drawing);

/// Its points in few numbers, metres: extents (6), mean (3), and 16 points along it (48), the first
/// and the last among them. A point between those is seen only by extents and mean.
std::vector<double> drawingShape(const Drawing& drawing);

}  // namespace rocinante
