#include "golden/housekeeping.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "golden/manifest_diff.h"
#include "golden/merged_report.h"
#include "golden/report_reader.h"
#include "golden/staging_folder.h"
#include "golden/suite_append.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Picture smallPicture(std::uint8_t level) {
  return {4, 4, std::vector<std::uint8_t>(4 * 4 * 4, level)};
}

AcceptedPicture entry(const std::string& file, const Picture& picture) {
  return {"k 4x4 1x", file, pictureXxh3(picture), "inputs", "session", "ada", "today", "why"};
}

JudgedFrame passed(double mean, std::int64_t over, Tolerance tolerance = {"arm", false, 4.0, 8}) {
  JudgedFrame judged;
  judged.verdict = FrameVerdict::same;
  judged.tolerance = std::move(tolerance);
  judged.limit_from = "[tolerance.arm], s.toml:9";
  judged.comparison.worst_tile_mean = mean;
  judged.comparison.worst_tile_over = over;
  return judged;
}

TEST(FolderFaults, TellsWhatIsStaleMissingStrayAndLeftOver) {
  const test::TemporaryFolder root;
  const GoldenFolder folder(root.path(), {});
  Manifest manifest;
  manifest.accept("kept", entry("kept.png", smallPicture(1)));
  manifest.accept("gone", entry("gone.png", smallPicture(2)));
  manifest.accept("old", entry("old.png", smallPicture(3)));
  ASSERT_TRUE(writePng(root / "kept.png", smallPicture(9)).ok());
  ASSERT_TRUE(writePng(root / "old.png", smallPicture(3)).ok());
  std::ofstream(root / "spare.png") << "x";
  std::filesystem::create_directory(root / ".staged-killed");
  const auto in_use = StagingFolder::make(root.path());
  ASSERT_TRUE(in_use.ok());
  std::ofstream(root / "notes.txt") << "x";
  std::vector<SuiteFrame> frames(2);
  frames[0].name = "kept";
  frames[1].name = "gone";
  const std::string at = root.path().string() + "/";
  EXPECT_THAT(
      folderFaults(manifest, folder, frames, false),
      ElementsAre(at + ".staged-killed was left by an approve that was interrupted; the next one "
                       "clears it",
                  "file " + at + "spare.png is no golden", "golden " + at + "gone.png is missing",
                  "golden " + at + "old.png is stale: the suite has no frame old"));
  EXPECT_THAT(folderFaults(manifest, folder, frames, true),
              testing::Contains(HasSubstr("kept.png is not the picture")));
}

TEST(SuiteNotes, TellsLimitsFourTimesLooserThanNeeded) {
  EXPECT_THAT(suiteNotes(std::vector{passed(0.5, 1), passed(0.9, 2)}),
              ElementsAre("tolerance arm ([tolerance.arm], s.toml:9) is loose: of tile_mean 4.00 "
                          "at most 0.90 was needed, of tile_over 8 at most 2"));
  EXPECT_THAT(suiteNotes(std::vector{passed(0.5, 1), passed(1.0, 2)}), IsEmpty());
  EXPECT_THAT(suiteNotes(std::vector{passed(0.5, 3)}), IsEmpty());
  EXPECT_THAT(suiteNotes(std::vector{passed(0, 0, Tolerance::exactly())}), IsEmpty());
  EXPECT_THAT(suiteNotes(std::vector{passed(0.01, 0, Tolerance::rounding())}), IsEmpty());
}

TEST(SuiteNotes, TellsMasksThatHideNothingAnywhere) {
  std::vector<JudgedFrame> judged(2);
  for (JudgedFrame& one : judged) {
    one.frame.case_name = "pick";
    one.masks = {{"arm", 0}, {"gone", 0}, {"the golden's own", 0}};
    one.own_masks = 2;
  }
  judged[1].masks[0].pixels = 5;
  EXPECT_THAT(suiteNotes(judged), ElementsAre("mask gone of case pick hides nothing"));
}

TEST(ManifestChanges, TellsReplacedNewAndRemoved) {
  Manifest then;
  Manifest now;
  then.accept("kept", entry("kept.png", smallPicture(1)));
  now.accept("kept", entry("kept.png", smallPicture(1)));
  then.accept("replaced", entry("replaced.png", smallPicture(2)));
  now.accept("replaced", entry("replaced.png", smallPicture(3)));
  then.accept("removed", entry("removed.png", smallPicture(4)));
  now.accept("new", entry("new.png", smallPicture(5)));
  now.accept("../up", entry("up.png", smallPicture(6)));
  const auto read = [](const AcceptedPicture& accepted) -> Result<Picture> {
    for (std::uint8_t level = 1; level < 6; ++level) {
      if (accepted.pixels == pictureXxh3(smallPicture(level))) return smallPicture(level);
    }
    return Error{ErrorKind::not_found, "there is none", accepted.picture};
  };
  std::vector<std::string> lines;
  for (const JudgedFrame& judged : manifestChanges(then, read, now, read, "v1")) {
    lines.push_back(std::string(nameOf(judged.verdict)) + " " + judged.frame.name + ": " +
                    judged.rule);
  }
  EXPECT_THAT(lines, ElementsAre("incomparable _.._up: there is none (up.png)",
                                 "same kept: equal pixel hash",
                                 "missing new: new since v1, accepted by ada on today: why",
                                 "missing removed: removed since v1",
                                 "different replaced: 16 differing pixels (exact) since v1, "
                                 "accepted by ada on today: why"));
}

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
  EXPECT_EQ(mergeFault({shard(1, 2, "a"), shard(1, 2, "a")}), "shard 1/2 is there twice");
  EXPECT_EQ(mergeFault({shard(1, 2, "a"), shard(2, 2, "a")}), "two reports have a frame a");
  EXPECT_EQ(mergeFault({shard(1, 2, "a"), shard(2, 3, "b")}),
            "shards of 2 and of 3 are no one run");
  SuiteReport other = shard(2, 2, "b");
  other.session = "def";
  EXPECT_EQ(mergeFault({shard(1, 2, "a"), other}), "the shards judged different sessions");
}

TEST(ParseReport, ReadsWhatReportJsonWrites) {
  SuiteReport report = shard(2, 3, "a");
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
  SuiteReport report = shard(1, 1, "a");
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
            "two suites have a frame a: one page has each name once, so rename one or report them "
            "apart");
}

TEST(ParseReport, RefusesNamesThatLeadElsewhere) {
  for (const char* name : {"../up", ".hidden", "", "a/b"}) {
    const std::string text =
        std::string(R"({"format":1,"frames":[{"verdict":"same","name":")") + name + "\"}]}";
    EXPECT_FALSE(parseReport(text, "report.json").ok()) << name;
  }
}

TEST(WithCase, KeepsEveryByteBeforeIt) {
  const std::string suite = "format = 1\r\ncell = \"c\"\r\n# comment\r\n[[case]]\r\nname = \"a\"";
  NewCase added{"b", {}};
  added.addText("at", "1\"2\\");
  added.addTexts("tags", {"x", "y"});
  const auto text = withCase(suite, added, "s.toml");
  ASSERT_TRUE(text.ok()) << text.error().text();
  EXPECT_EQ(*text, suite +
                       "\r\n\r\n[[case]]\r\nname = \"b\"\r\nat = \"1\\\"2\\\\\"\r\n"
                       "tags = [\"x\", \"y\"]\r\n");
}

TEST(WithCase, RefusesWhatWouldNotBeSound) {
  const std::string suite = "format = 1\ncell = \"c\"\n[[case]]\nname = \"a\"\n";
  EXPECT_FALSE(withCase(suite, {"a", {}}, "s.toml").ok());
  EXPECT_FALSE(withCase(suite, {"../b", {}}, "s.toml").ok());
  EXPECT_FALSE(withCase(suite, {"b", {{"samples", "3"}}}, "s.toml").ok());
  EXPECT_FALSE(
      withCase("format = 1\ncell = \"c\"\ncase = [{ name = \"a\" }]\n", {"b", {}}, "s").ok());
  EXPECT_TRUE(withCase("format = 1\ncell = \"c\"\n", {"b", {}}, "s.toml").ok());
}

}  // namespace
}  // namespace rocinante
