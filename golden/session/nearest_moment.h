#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/session/timeline.h"
#include "golden/run/run_spec.h"

namespace rocinante {

/// The one of `candidates`, times of b, at which b's state is most like that of a at `in_a`: fewest
/// devices, colours and drawings that are not the same, then links nearest to their place relative
/// to the limits, then nearest to `in_b`.
Result<LogTime> nearestMoment(const Cell& cell, Timeline& a, LogTime in_a, Timeline& b,
                              LogTime in_b, const std::vector<LogTime>& candidates,
                              const RunLimits& limits);

}  // namespace rocinante
