#pragma once

#include <filesystem>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "viewer/page/page_job.h"

namespace rocinante {

/// The log that the page carries: the job's own, byte for byte, or what `rocinante log cut` makes
/// of it for the job's span. The cell that a log carries is left out, since the page has its own; a
/// damaged log keeps it. Warns in the report of damage that the cut had to leave out.
Result<Bytes> carriedLog(const PageJob& job, PageReport& report);

}  // namespace rocinante
