#include "golden/suite.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

using namespace std::chrono_literals;

constexpr char kHead[] = "format = 1\ncell = \"c.toml\"\n";

std::string faultOf(const std::string& text) {
  const auto suite = parseSuite(text, "s.toml");
  return suite.ok() ? "none" : suite.error().text();
}

TEST(ParseSuite, ReadsEveryKey) {
  const auto suite = parseSuite(R"(
format = 1
cell = "cell.toml"
log = "session.mcap"
goldens = "accepted"
[[case]]
name = "pick"
event = "picked"
after = "250ms"
camera = "overview"
size = [320, 240]
samples = 2
hide = ["layer/labels"]
show = ["arm"]
tolerance = { tile_mean = 1.5, tile_over = 3 }
tags = ["slow"]
x-note = "anything"
[[case]]
name = "tour"
every = "0.5s"
tolerance = "cpu"
)",
                                "suites/s.toml");
  ASSERT_TRUE(suite.ok()) << suite.error().text();
  EXPECT_EQ(suite->cell, "suites/cell.toml");
  EXPECT_EQ(*suite->log, "suites/session.mcap");
  EXPECT_EQ(suite->goldens, "suites/accepted");
  ASSERT_EQ(suite->cases.size(), 2U);
  const SuiteCase& pick = suite->cases[0];
  EXPECT_EQ(pick.moment.event, "picked");
  EXPECT_EQ(pick.moment.after, 250ms);
  EXPECT_EQ(pick.width, 320);
  EXPECT_EQ(pick.samples, 2);
  EXPECT_EQ(pick.hide, std::vector<std::string>{"layer/labels"});
  EXPECT_FALSE(pick.tolerance.exact);
  EXPECT_DOUBLE_EQ(pick.tolerance.tile_mean, 1.5);
  EXPECT_EQ(suite->cases[1].moment.every, 500ms);
  EXPECT_EQ(suite->cases[1].tolerance.name, "cpu");
}

TEST(ParseSuite, ALogMayBringItsCell) {
  const std::string one_case = "[[case]]\nname = \"a\"\nat = \"1s\"\n";
  const auto suite = parseSuite("format = 1\nlog = \"session.mcap\"\n" + one_case, "suites/s.toml");
  ASSERT_TRUE(suite.ok()) << suite.error().text();
  EXPECT_TRUE(suite->cell.empty());
  EXPECT_EQ(faultOf("format = 1\n" + one_case),
            "a suite names its `cell`, or a `log` that carries one (s.toml:1:1)");
}

TEST(ParseSuite, EveryFaultNamesItsPlace) {
  const std::string head = kHead;
  const std::string named = head + "[[case]]\nname = \"a\"\n";
  EXPECT_EQ(faultOf("format = 2\ncell = \"c\"\n[[case]]\nname = \"a\"\n"),
            "a suite begins with `format = 1` (s.toml:1:1)");
  EXPECT_EQ(faultOf(head), "a suite has at least one [[case]] (s.toml:1:1)");
  EXPECT_EQ(faultOf(named + "colour = 1\n"), "unknown key `colour` (s.toml:5:10)");
  EXPECT_EQ(faultOf(named + "samples = 3\n"), "`samples` is 1, 2, 4 or 8 (s.toml:5:11)");
  EXPECT_EQ(faultOf(named + "size = [0, 5]\n"),
            "`size` is [width, height], each from 1 to 8192 (s.toml:5:8)");
  EXPECT_EQ(faultOf(named + "at = 12.5\n"), "`at` is a string (s.toml:5:6)");
  EXPECT_EQ(faultOf(named + "every = \"0s\"\n"),
            "`every` is a duration above zero, such as \"0.5s\" (s.toml:5:9)");
  EXPECT_EQ(faultOf(named + "at = \"1\"\nevent = \"e\"\n"),
            "a case has one of `at`, `event` and `every` (s.toml:3:1)");
  EXPECT_EQ(faultOf(named + "tolerance = \"lax\"\n"),
            "`tolerance` is \"exact\", \"cpu\", \"loose\" or { tile_mean = ..., tile_over = ... } "
            "(s.toml:5:13)");
  EXPECT_EQ(faultOf(named + "[[case]]\nname = \"a\"\n"), "two cases are named `a` (s.toml:5:1)");
  EXPECT_EQ(faultOf(head + "[[case]]\nname = \"../up\"\n"),
            "a case has a `name` of letters, digits, `_`, `-` and `.` (s.toml:3:1)");
  EXPECT_NE(faultOf("format = = 1"), "none");
}

}  // namespace
}  // namespace rocinante
