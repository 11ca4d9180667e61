#include "golden/report/report_reader.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "core/base/json_read.h"
#include "golden/why/frame_why.h"

namespace rocinante {
namespace {

SuiteReport shard(int number, int of) {
  SuiteReport report;
  report.suite = "s.toml";
  report.shard = number;
  report.shards = of;
  JudgedFrame judged;
  judged.frame.name = "a";
  judged.verdict = FrameVerdict::same;
  report.frames.push_back(judged);
  return report;
}

TEST(ParseReport, ReadsWhatReportJsonWrites) {
  SuiteReport report = shard(2, 3);
  report.notes = {"mask x of case a hides nothing"};
  report.frames[0].rule = "equal pixel hash";
  report.frames[0].limit_from = "s.toml:3";
  report.frames[0].frame.tags = {"slow"};
  const std::string text = reportJson(report);
  const auto read = parseReport(text, "report.json");
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(reportJson(*read), text);
}

TEST(ParseReport, KeepsLimitsMasksFiguresAndCommands) {
  SuiteReport report = shard(1, 1);
  report.run_one_command = "rocinante golden run s.toml --only";
  report.approve_from_command = "rocinante golden approve s.toml --from LIST";
  JudgedFrame& judged = report.frames[0];
  judged.frame.place = 7;
  judged.tolerance = {"lax", false, 3.5, 9};
  judged.masks = {{"arm", 12}, {"the golden's own", 3}};
  judged.own_masks = 1;
  judged.comparison.differing = 40;
  judged.comparison.worst_x = 5;
  judged.comparison.worst_tile_over = 2;
  const std::string text = reportJson(report);
  const auto read = parseReport(text, "report.json");
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(reportJson(*read), text);
  EXPECT_FALSE(read->frames[0].tolerance.exact);
  EXPECT_EQ(read->frames[0].own_masks, 1U);
}

/// Those that nameOf() knows.
template <class Enum>
std::vector<Enum> enumerators() {
  std::vector<Enum> known;
  constexpr auto kPastAll = static_cast<Enum>(31);
  for (int number = 0; number < 31; ++number) {
    const auto one = static_cast<Enum>(number);
    if (enumeratorNamed(nameOf(one), kPastAll) == one) known.push_back(one);
  }
  return known;
}

TEST(ParseReport, KeepsEveryVerdictAndKind) {
  SuiteReport report = shard(1, 1);
  auto why = std::make_shared<FrameWhy>();
  for (const ChangeKind kind : enumerators<ChangeKind>()) {
    why->blame.changes.emplace_back().kind = kind;
  }
  ASSERT_EQ(why->blame.changes.size(), 7U);
  report.frames[0].why = why;
  for (const FrameVerdict verdict : enumerators<FrameVerdict>()) {
    JudgedFrame& judged = report.frames.emplace_back();
    judged.frame.name = nameOf(verdict);
    judged.verdict = verdict;
  }
  ASSERT_EQ(report.frames.size(), 1 + kFrameVerdicts.size());
  JudgedRun& run = report.runs.emplace_back();
  run.name = "lift";
  for (const auto kind : enumerators<RunFinding::Kind>()) {
    run.judgement.findings.emplace_back().kind = kind;
  }
  ASSERT_EQ(run.judgement.findings.size(), 9U);
  const std::string text = reportJson(report);
  const auto read = parseReport(text, "report.json");
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(reportJson(*read), text);
}

TEST(ParseReport, RefusesNamesThatLeadElsewhere) {
  for (const char* name : {"../up", ".hidden", "", "a/b"}) {
    const std::string text =
        std::string(R"({"format":1,"frames":[{"verdict":"same","name":")") + name + "\"}]}";
    EXPECT_FALSE(parseReport(text, "report.json").ok()) << name;
  }
}

}  // namespace
}  // namespace rocinante
