#pragma once

#include "recorder/spy/spy_report.h"

namespace rocinante {

/// Fills `reasons` from the rest: the answer to "nothing moves, why?".
void findReasons(SpyReport& report);

}  // namespace rocinante
