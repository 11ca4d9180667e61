#pragma once

#include "recorder/spy/spy_report.h"

namespace rocinante {

/// Fills `reasons`: the answer to "nothing moves, why?". `judged`: what the judges of `check` found
/// in the stream.
void addReasons(SpyReport& report, Findings judged);

/// The id that a rule had in spy's JSON before spy took check's rules; the rule itself when it is
/// newer. Gone with 1.0.
std::string_view oldReasonOf(std::string_view rule);

}  // namespace rocinante
