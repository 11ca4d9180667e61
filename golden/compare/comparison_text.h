#pragma once

#include <string>

#include "golden/compare/compare.h"
#include "golden/compare/picture_figures.h"

namespace rocinante {

/// How far and where two pictures differ, for people: lines of figures, and the map, each line
/// ended. `judged` is the frame as it was judged. Empty when no pixel differs.
std::string differenceText(const Comparison& found, const PictureFigures& figures,
                           const Picture& judged, const Picture& golden);

}  // namespace rocinante
