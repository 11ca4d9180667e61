#pragma once

#include "core/base/result.h"
#include "core/check/rules/check_report.h"
#include "tests/core/check/rules/rule_page.h"

namespace rocinante::test {

/// Judges an example like the program: its cell, and its session as a real log, which carries the
/// cell below `recorded/` if there is one. Files are in a temporary folder.
Result<CheckReport> judgeExample(const RuleExample& example);

}  // namespace rocinante::test
