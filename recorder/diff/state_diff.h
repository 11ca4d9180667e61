#pragma once

#include <functional>

#include "core/base/result.h"
#include "core/log/log_reader.h"
#include "recorder/diff/log_diff.h"

namespace rocinante {

/// Folds two logs side by side from their beginnings, and finds the first log time at which their
/// states differ.
Result<StateDiff> diffStates(LogReader& a, LogReader& b,
                             const std::function<void(LogTime)>& progress);

}  // namespace rocinante
