#include <gtest/gtest.h>

#include "golden/report/report_reader.h"

namespace rocinante {
namespace {

SuiteReport shard(int number, int of, const std::string& frame) {
  SuiteReport report;
  report.suite = "s.toml";
  report.renderer = "llvmpipe";
  report.session = "abc";
  report.shard = number;
  report.shards = of;
  JudgedFrame judged;
  judged.frame.name = frame;
  judged.verdict = FrameVerdict::same;
  report.frames.push_back(judged);
  return report;
}

std::string mergeFault(std::vector<SuiteReport> parts) {
  const auto merged = mergeReports(std::move(parts));
  return merged.ok() ? "none" : merged.error().what;
}

TEST(MergeReports, NeedsEveryShardOnceOfOneRun) {
  EXPECT_EQ(mergeFault({shard(2, 2, "b"), shard(1, 2, "a")}), "none");
  EXPECT_EQ(mergeFault({shard(1, 2, "a")}), "shard 2/2 is missing");
  EXPECT_EQ(mergeFault({shard(1, 2, "a"), shard(1, 2, "a")}), "shard 1/2 was given twice");
  EXPECT_EQ(mergeFault({shard(1, 2, "a"), shard(2, 2, "a")}), "two reports have a frame a");
  EXPECT_EQ(mergeFault({shard(1, 2, "a"), shard(2, 3, "b")}),
            "shards come from different runs (of 2 and of 3 shards)");
  SuiteReport other = shard(2, 2, "b");
  other.session = "def";
  EXPECT_EQ(mergeFault({shard(1, 2, "a"), other}), "the shards judged different sessions");
}

TEST(MergeReports, GivesFramesOfSeveralSuitesTheirOwnCommands) {
  std::vector<SuiteReport> parts{shard(1, 1, "a"), shard(1, 1, "b")};
  parts[1].suite = "t.toml";
  for (SuiteReport& part : parts) {
    part.run_one_command = "rocinante golden run " + part.suite + " --only";
    part.approve_from_command = "rocinante golden approve " + part.suite + " --from LIST";
    part.notes = {"a note of " + part.suite};
  }
  const auto merged = mergeReports(parts);
  ASSERT_TRUE(merged.ok()) << merged.error().text();
  EXPECT_EQ(merged->frames[1].run_command, "rocinante golden run t.toml --only");
  EXPECT_EQ(merged->approve_from_command, "");  // a list is one suite's
  EXPECT_EQ(merged->notes.size(), 2U);
  parts[1].frames[0].frame.name = "a";
  EXPECT_EQ(mergeFault(parts),
            "two suites have a frame a; a report needs unique names: rename one, or write two "
            "reports");
}

}  // namespace
}  // namespace rocinante
