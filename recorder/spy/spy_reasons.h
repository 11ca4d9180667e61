#pragma once

#include "recorder/spy/spy_report.h"

namespace rocinante {

/// Fills `reasons`: the answer to "nothing moves, why?". `judged`: what the judges of `check` found
/// in the stream.
void addReasons(SpyReport& report, Findings judged);

}  // namespace rocinante
