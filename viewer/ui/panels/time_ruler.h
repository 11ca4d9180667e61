#pragma once

#include <string>

#include "core/base/time.h"

namespace rocinante {

/// Distance of the ticks of a time line that shows `span` on `width_px`, so that labels of that
/// width do not touch: 1, 2 or 5 times a power of ten below a second, then 1, 2, 5, 10, 15 or 30
/// seconds, minutes or hours below a day, then days by powers of two. Pure.
Nanoseconds rulerStep(Nanoseconds span, double width_px, double label_px);

/// "12.5", "1:05", "-0.5", "2:00:00": the label of a tick, with the decimals that the step needs.
std::string rulerLabel(Nanoseconds since_origin, Nanoseconds step);

}  // namespace rocinante
