#pragma once

#include <vector>

#include "core/base/result.h"
#include "golden/report/report.h"

namespace rocinante {

/// Merges reports: all shards of one run, or runs of several suites. refused when a shard is
/// missing or given twice, when two reports have a frame of the same name, and when shards of one
/// run have different sessions or renderers.
Result<SuiteReport> mergeReports(std::vector<SuiteReport> parts);

}  // namespace rocinante
