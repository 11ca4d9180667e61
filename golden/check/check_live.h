#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/check/rules/check_report.h"

namespace rocinante {

/// Judges the datagrams received at all endpoints together for `duration`; with a trust file, only
/// those that it trusts. A stop signal ends it early, and the report says that it was interrupted.
/// Prints on standard error the bound endpoints, what was not trusted, and at the end those of
/// several endpoints at which nothing arrived.
Result<CheckReport> checkLive(const Cell& cell, const std::vector<std::string>& endpoints,
                              const std::string& trust_file, Nanoseconds duration);

}  // namespace rocinante
