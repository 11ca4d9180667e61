#pragma once

#include <string>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/check/rules/finding.h"

namespace rocinante {

/// Judges the datagrams received at an endpoint for `duration`. A stop signal ends it early, and
/// the report says that it was interrupted. Prints the bound endpoint on standard error.
Result<CheckReport> checkLive(const Cell& cell, const std::string& endpoint, Nanoseconds duration);

}  // namespace rocinante
