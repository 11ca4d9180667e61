#pragma once

#include <string>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/check/rules/finding.h"

namespace rocinante {

/// Judges what arrives at an endpoint for a while. A stop signal ends it early: the report then
/// says that it was interrupted. Says on standard error where it listens.
Result<CheckReport> checkLive(const Cell& cell, const std::string& endpoint, Nanoseconds duration);

}  // namespace rocinante
