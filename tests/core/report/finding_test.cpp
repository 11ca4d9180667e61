#include "core/report/finding.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

TEST(Finding, PrintsItsPlaceAsCompilersDo) {
  Finding finding{.rule = "cell.x", .text = "wrong", .hint = "mend it", .file = "a.toml"};
  EXPECT_EQ(finding.print(), "a.toml: error: wrong (mend it) [cell.x]");
  finding.line = 3;
  EXPECT_EQ(finding.place(), "a.toml:3");
  finding.column = 7;
  finding.hint.clear();
  EXPECT_EQ(finding.print(), "a.toml:3:7: error: wrong [cell.x]");
}

TEST(Finding, TheFirstErrorIsNotTheFirstFinding) {
  Findings findings = {
      {.rule = "a.a", .severity = Severity::note}, {.rule = "a.b"}, {.rule = "a.c"}};
  ASSERT_NE(firstError(findings), nullptr);
  EXPECT_EQ(firstError(findings)->rule, "a.b");
  EXPECT_EQ(countOf(findings, Severity::error), 2U);
  EXPECT_EQ(firstError({}), nullptr);
}

}  // namespace
}  // namespace rocinante
