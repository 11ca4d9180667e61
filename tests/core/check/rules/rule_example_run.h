#pragma once

#include "core/base/result.h"
#include "core/check/rules/finding.h"
#include "tests/core/check/rules/rule_page.h"

namespace rocinante::test {

/// Judges an example as the program would: its cell, and its session as a real log, which carries
/// the cell below `recorded/` where the example has one. Files lie in a folder of their own, which
/// is gone afterwards.
Result<CheckReport> judgeExample(const RuleExample& example);

}  // namespace rocinante::test
