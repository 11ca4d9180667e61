#pragma once

#include <string>

#include "golden/compare/compare.h"

namespace rocinante {

/// Text of the differences: figures and the map, each line with its newline. `judged` is the frame
/// as judged. Empty when no pixel differs.
std::string differenceText(const Comparison& found, const Picture& judged, const Picture& golden);

}  // namespace rocinante
