#pragma once

#include "core/base/result.h"
#include "core/log/log_reader.h"
#include "recorder/copy/log_selection.h"

namespace rocinante {

/// The error that says that a choice holds no message of a log, and why, as far as it can be seen:
/// the log is empty or could not be read, the time lies outside it, or no topic matches.
/// Once the log has been read.
Error nothingChosen(const LogReader& log, const SelectionOptions& selection,
                    const TimeRange& range);

}  // namespace rocinante
