#pragma once

#include <string>
#include <vector>

#include "golden/run/column_samples.h"
#include "golden/run/motion_judge.h"

namespace rocinante {

/// Judges a joint's value, or position and turn of a pose, by the two rules of docs/decisions/041.
/// Appends to `findings` the measures that are beyond their limit.
ColumnOutcome judgeColumn(const RunTimes& times, const std::string& item, const TrackColumn& column,
                          const std::vector<ColumnSamples>& accepted, const ColumnSamples& run,
                          std::vector<RunFinding>& findings);

}  // namespace rocinante
