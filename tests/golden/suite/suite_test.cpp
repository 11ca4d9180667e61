#include "golden/suite/suite.h"

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
  EXPECT_EQ(pick.cameras, std::vector<std::string>{"overview"});
  EXPECT_EQ(pick.limit_from, "suites/s.toml:15");
  EXPECT_EQ(suite->cases[1].moment.every, 500ms);
  EXPECT_EQ(suite->cases[1].tolerance.name, "cpu");
}

TEST(ParseSuite, WithoutAToleranceRoundingJudgesAcrossKeysAndWhatIsWrittenHoldsThereToo) {
  const std::string head = "format = 1\ncell = \"c.toml\"\n[tolerance.arm]\ntile_mean = 2.0\n";
  const auto caseOf = [&](const std::string& defaults, const std::string& keys) {
    const auto suite =
        parseSuite(head + "[defaults]\n" + defaults + "[[case]]\nname = \"a\"\n" + keys, "s.toml");
    EXPECT_TRUE(suite.ok()) << suite.error().text();
    return suite.ok() ? suite->cases.front() : SuiteCase{};
  };
  EXPECT_EQ(caseOf("", "").tolerance.name, "exact");
  EXPECT_EQ(caseOf("", "").across_keys.name, "rounding");
  for (const char* name : {"exact", "rounding", "cpu", "loose", "arm"}) {
    const std::string key = std::string("tolerance = \"") + name + "\"\n";
    for (const SuiteCase& made : {caseOf("", key), caseOf(key, "")}) {
      EXPECT_EQ(made.tolerance.name, name);
      EXPECT_EQ(made.across_keys.name, name);
    }
  }
  const SuiteCase own = caseOf("tolerance = \"exact\"\n", "tolerance = { tile_mean = 1.0 }\n");
  EXPECT_EQ(own.across_keys.name, "own limits");
  EXPECT_DOUBLE_EQ(own.across_keys.tile_mean, 1.0);
}

TEST(ParseSuite, ReadsMomentsLooksMasksAndExpectations) {
  const auto suite = parseSuite(R"(
format = 1
cell = "cell.toml"
store = "/srv/goldens"
[defaults]
size = [320, 200]
tags = ["nightly"]
tolerance = "arm"
[tolerance.arm]
tile_mean = 1.0
tile_over = 4
[[case]]
name = "again"
event = "picked"
occurrence = -1
camera = ["overview", "top"]
layers = ["robots"]
insets = false
style = { edges = "only", shadows = true, trail = ["arm@3", "arm/link6@1"] }
mask = ["layer/labels", { path = "arm/link6", grow = 2 }, { rectangle = [0, 0, 64, 20] }]
judge_only = "arm"
expect = "different"
reason = "the gripper is being redrawn"
[[case]]
name = "each"
events = "pick*"
after = "10ms"
tolerance = "exact"
tags = []
scale = 1.5
insets = ["map:top-left", "fit"]
)",
                                "s.toml");
  ASSERT_TRUE(suite.ok()) << suite.error().text();
  EXPECT_EQ(suite->store, "/srv/goldens");
  const SuiteCase& again = suite->cases[0];
  EXPECT_EQ(again.moment.occurrence, -1);
  EXPECT_EQ(again.cameras, (std::vector<std::string>{"overview", "top"}));
  EXPECT_EQ(again.width, 320);
  EXPECT_EQ(again.layers, std::vector<std::string>{"robots"});
  EXPECT_TRUE(again.insets && again.insets->empty());
  EXPECT_EQ(again.style.edges, EdgeStyle::only);
  EXPECT_EQ(again.style.trails.size(), 2U);
  EXPECT_EQ(again.mask, (std::vector<PictureArea>{{{}, "layer/labels", 0},
                                                  {{}, "arm/link6", 2},
                                                  {MaskRectangle{0, 0, 64, 20}, "", 0}}));
  EXPECT_EQ(again.judge_only.size(), 1U);
  EXPECT_TRUE(again.expect_different);
  EXPECT_EQ(again.tolerance.name, "arm");
  EXPECT_EQ(again.limit_from, "[defaults], [tolerance.arm], s.toml:8");
  EXPECT_EQ(again.tags, std::vector<std::string>{"nightly"});
  const SuiteCase& each = suite->cases[1];
  EXPECT_EQ(each.moment.events, "pick*");
  EXPECT_EQ(each.moment.after, 10ms);
  EXPECT_TRUE(each.tolerance.exact);
  EXPECT_EQ(each.limit_from, "s.toml:28");
  EXPECT_TRUE(each.tags.empty());
  EXPECT_EQ(each.scale, 1.5);
  ASSERT_TRUE(each.insets && each.insets->size() == 2);
  EXPECT_EQ(each.insets->front().corner, InsetCorner::top_left);
}

TEST(ParseSuite, ALogMayBringItsCell) {
  const std::string one_case = "[[case]]\nname = \"a\"\nat = \"1s\"\n";
  const auto suite = parseSuite("format = 1\nlog = \"session.mcap\"\n" + one_case, "suites/s.toml");
  ASSERT_TRUE(suite.ok()) << suite.error().text();
  EXPECT_TRUE(suite->cell.empty());
  EXPECT_EQ(faultOf("format = 1\n" + one_case),
            "a suite needs a `cell`, or a `log` that carries one (s.toml:1:1)");
}

TEST(ParseSuite, EveryFaultNamesItsPlace) {
  const std::string head = kHead;
  const std::string named = head + "[[case]]\nname = \"a\"\n";
  EXPECT_EQ(faultOf("format = 2\ncell = \"c\"\n[[case]]\nname = \"a\"\n"),
            "a suite must begin with `format = 1` (s.toml:1:1)");
  EXPECT_EQ(faultOf(head), "a suite needs at least one [[case]] or [[run]] (s.toml:1:1)");
  EXPECT_EQ(faultOf(named + "colour = 1\n"), "unknown key `colour` (s.toml:5:10)");
  EXPECT_EQ(faultOf(named + "samples = 3\n"), "`samples` must be 1, 2, 4 or 8 (s.toml:5:11)");
  EXPECT_EQ(faultOf(named + "scale = 9\n"), "`scale` must be 0.5 to 4 (s.toml:5:9)");
  EXPECT_EQ(faultOf(named + "size = [0, 5]\n"),
            "`size` must be [width, height], each from 1 to 8192 (s.toml:5:8)");
  EXPECT_EQ(faultOf(named + "at = 12.5\n"), "`at` is a string (s.toml:5:6)");
  EXPECT_EQ(faultOf(named + "every = \"0s\"\n"),
            "`every` must be a duration above zero, such as \"0.5s\" (s.toml:5:9)");
  EXPECT_EQ(faultOf(named + "at = \"1\"\nevent = \"e\"\n"),
            "a case can have only one of `at`, `event`, `events` and `every` (s.toml:3:1)");
  EXPECT_EQ(faultOf(named + "tolerance = \"lax\"\n"),
            "`tolerance` must be \"exact\", \"rounding\", \"cpu\", \"loose\" or { tile_mean = ..., "
            "tile_over = ... } (s.toml:5:13)");
  EXPECT_EQ(faultOf(named + "[[case]]\nname = \"a\"\n"), "two cases are named `a` (s.toml:5:1)");
  EXPECT_EQ(faultOf(head + "[[case]]\nname = \"../up\"\n"),
            "a case needs a `name` of at most 100 letters, digits, `_`, `-` and `.` (s.toml:3:1)");
  EXPECT_EQ(faultOf(named + "after = \"1s\"\n"), "`after` needs `event` or `events` (s.toml:5:9)");
  EXPECT_EQ(faultOf(named + "occurrence = 0\nevent = \"e\"\n"),
            "`occurrence` needs `event` and is 1 for the first, -1 for the last (s.toml:5:14)");
  EXPECT_EQ(faultOf(named + "expect = \"different\"\n"),
            "a case that expects a difference needs `reason = \"...\"` (s.toml:5:10)");
  EXPECT_EQ(faultOf(named + "reason = \"why\"\n"), "`reason` needs `expect` (s.toml:5:10)");
  EXPECT_EQ(faultOf(named + "mask = [\"layer/grid\"]\n"),
            "`hide` layer/grid instead: it then needs no mask (s.toml:5:9)");
  EXPECT_EQ(faultOf(named + "mask = [{ rectangle = [0, 0, 0, 5] }]\n"),
            "`rectangle` must be [x, y, width, height] in pixels (s.toml:5:23)");
  EXPECT_EQ(faultOf(named + "mask = [{ grow = 1 }]\n"),
            "an area needs either a `path` or a `rectangle` (s.toml:5:9)");
  EXPECT_NE(faultOf(named + "style = { edges = \"bold\" }\n"), "none");
  EXPECT_NE(faultOf(named + "style = { glow = true }\n"), "none");
  EXPECT_EQ(faultOf(named + "[tolerance.cpu]\ntile_mean = 1.0\n"),
            "`cpu` is a tier: choose another name (s.toml:5:1)");
  EXPECT_EQ(faultOf(head + "[defaults]\nname = \"a\"\n[[case]]\nname = \"a\"\n"),
            "unknown key `name` (s.toml:4:8)");
  EXPECT_NE(faultOf("format = = 1"), "none");
}

}  // namespace
}  // namespace rocinante
