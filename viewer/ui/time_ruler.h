#pragma once

#include <string>

#include "core/time.h"

namespace rocinante {

/// How far apart the ticks of a time line stand that shows `span` on `width_px`: the least of 1, 2
/// and 5 times a power of ten, and from a minute on of 1, 2, 5, 10, 15 and 30 minutes and hours,
/// for which labels of that width do not touch. Pure.
Nanoseconds rulerStep(Nanoseconds span, double width_px, double label_px);

/// "12.5", "1:05", "-0.5", "2:00:00": what a tick says; as many decimals as the step needs.
std::string rulerLabel(Nanoseconds since_origin, Nanoseconds step);

}  // namespace rocinante
