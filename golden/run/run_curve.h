#pragma once

#include <cstdint>
#include <vector>

#include "golden/run/column_samples.h"
#include "golden/run/run_judgement.h"

namespace rocinante {

struct RunTimes;

/// The band and the run's value over the accepted session, for a column of one number; `scale`
/// makes it the unit of `limit`. At most a few hundred points: of each stretch the band, and the
/// value that is farthest outside. `reach`: how much earlier or later a value may come.
RunCurve runCurve(const RunTimes& times, const std::vector<ColumnSamples>& accepted,
                  const ColumnSamples& run, double scale, std::int64_t reach, double limit);

}  // namespace rocinante
