#include "golden/judge/housekeeping.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "golden/approval/staging_folder.h"
#include "golden/suite/suite_neighbours.h"
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
      ElementsAre(at + ".staged-killed was left by an interrupted approve; the next approve "
                       "removes it",
                  "file " + at + "spare.png is not a golden of the manifest",
                  "golden " + at + "gone.png is missing",
                  "golden " + at + "old.png is stale: the suite has no frame old"));
  EXPECT_THAT(folderFaults(manifest, folder, frames, true),
              testing::Contains(HasSubstr("kept.png is not the picture")));
}

TEST(FolderFaults, WhatASuiteBesideItHasIsNotStale) {
  const test::TemporaryFolder root;
  const auto write = [&](const char* name, const std::string& text) {
    std::ofstream(root / name) << "format = 1\n" << text;
  };
  write("own.toml", "cell = \"x.toml\"\n[[case]]\nname = \"own\"\n");
  write("b.toml",
        "log = \"x.mcap\"\n[[case]]\nname = \"b\"\n[[case]]\nname = \"tour\"\nevery = \"1s\"\n"
        "camera = [\"the top\", \"side\"]\n[[run]]\nname = \"lift\"\n");
  write("c.toml", "cell = \"x.toml\"\ngoldens = \"other\"\n[[case]]\nname = \"c\"\n");
  write("cell.toml", "[[device]]\nname = \"d\"\n");
  const auto suite = readSuite(root / "own.toml");
  ASSERT_TRUE(suite.ok()) << suite.error().text();
  const auto neighbours = neighboursOf(*suite);
  ASSERT_EQ(neighbours.size(), 1U);
  const GoldenFolder folder(root / "goldens", {});
  std::filesystem::create_directory(root / "goldens");
  Manifest manifest;
  for (const std::string name : {"own", "b", "tour.the_top-00001.000s", "b-2", "tour", "tour.side2",
                                 "tour.front-00001.000s", "c"}) {
    manifest.accept(name, entry(name + ".png", smallPicture(1)));
    ASSERT_TRUE(writePng(root / "goldens" / (name + ".png"), smallPicture(1)).ok());
  }
  for (const char* name : {"lift", "drop"}) {
    manifest.runs[name].push_back({std::string(name) + ".mcap", "", "", "", "", "", ""});
    std::ofstream(root / "goldens" / (std::string(name) + ".mcap")) << "x";
  }
  std::vector<SuiteFrame> frames(1);
  frames[0].name = "own";
  std::string stale;
  for (const std::string& fault : folderFaults(manifest, folder, frames, false, {}, neighbours)) {
    EXPECT_THAT(fault, HasSubstr(" is stale: "));
    stale += fault.substr(fault.rfind(' ') + 1) + " ";
  }
  EXPECT_EQ(stale, "drop b-2 c tour.front-00001.000s tour tour.side2 ");
}

TEST(SuiteNotes, TellsLimitsFourTimesLooserThanNeeded) {
  EXPECT_THAT(suiteNotes(std::vector{passed(0.5, 1), passed(0.9, 2)}),
              ElementsAre("tolerance arm ([tolerance.arm], s.toml:9) is loose: tile_mean 4.00, "
                          "needed at most 0.90; tile_over 8, needed at most 2"));
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

TEST(SuiteNotes, TellsOnceWhatIsNotJudged) {
  std::vector<JudgedFrame> judged(3);
  for (JudgedFrame& one : judged) {
    one.golden = entry("a.png", smallPicture(1));
    one.coverage.emplace();
    one.coverage->judged = {"arm"};
    one.coverage->masked = {"hood"};
    one.coverage->left_out.leaveOut(
        {.kind = "device", .name = "arn", .reason = "the cell has no such device"});
  }
  EXPECT_THAT(suiteNotes(judged),
              ElementsAre("3 frames are judged without coverage: that a device is no longer judged "
                          "is not noticed until they are approved again",
                          "left out: 1 device `arn` (the cell has no such device)"));
  for (JudgedFrame& one : judged) one.golden->coverage = {"arm", "hood"};
  judged[1].golden->coverage.reset();
  judged[1].coverage->judged.clear();  // at rest, there is nothing to lose
  EXPECT_THAT(suiteNotes(judged),
              ElementsAre("all of hood is masked or hidden, which was judged when accepted",
                          "left out: 1 device `arn` (the cell has no such device)"));
}

TEST(SuiteNotes, TellsOnceThatJointsAreNotCovered) {
  std::vector<JudgedFrame> judged(3);
  for (JudgedFrame& one : judged) {
    one.golden = entry("a.png", smallPicture(1));
    one.golden->coverage = {"arm"};
    one.coverage.emplace();
    one.coverage->judged = {"arm", "arm/*"};
  }
  judged[1].coverage->judged = {"arm"};
  EXPECT_THAT(
      suiteNotes(judged),
      ElementsAre("2 frames are judged without coverage of joints: that a joint is no longer "
                  "judged is not noticed until they are approved again"));
  for (JudgedFrame& one : judged) one.golden->coverage = {"arm", "arm/*"};
  EXPECT_THAT(suiteNotes(judged), IsEmpty());
}

}  // namespace
}  // namespace rocinante
