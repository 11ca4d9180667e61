#pragma once

#include "core/base/result.h"
#include "core/copy/log_selection.h"
#include "core/log/log_reader.h"

namespace rocinante {

/// The error for a selection without messages, with the reason if it can be seen: the log is empty
/// or unreadable, the time is outside it, or no topic matches. Call after reading the log.
Error nothingChosen(const LogReader& log, const SelectionOptions& selection,
                    const TimeRange& range);

}  // namespace rocinante
