#pragma once

#include <vector>

#include "core/base/result.h"
#include "golden/report/report.h"

namespace rocinante {

/// One report of several: all shards of one run, or runs of several suites. refused when a shard
/// is missing or there twice, when two have a frame of one name, and when shards of one run judged
/// different sessions or with different renderers.
Result<SuiteReport> mergeReports(std::vector<SuiteReport> parts);

}  // namespace rocinante
