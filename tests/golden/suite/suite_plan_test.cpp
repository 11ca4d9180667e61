#include "golden/suite/suite_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rocinante {
namespace {

using testing::ElementsAre;

Suite suiteOf(const std::string& cases) {
  auto suite = parseSuite("format = 1\ncell = \"c.toml\"\n" + cases, "s.toml");
  EXPECT_TRUE(suite.ok()) << suite.error().text();
  return suite.ok() ? *suite : Suite{};
}

std::vector<std::string> namesOf(const std::vector<SuiteFrame>& frames) {
  std::vector<std::string> names;
  for (const SuiteFrame& frame : frames) names.push_back(frame.name);
  return names;
}

std::vector<std::string> selected(const Suite& suite, const FrameSelection& selection) {
  auto frames = planFrames(suite, nullptr);
  EXPECT_TRUE(frames.ok());
  const auto left = selectFrames(std::move(*frames), selection, suite);
  return left.ok() ? namesOf(*left) : std::vector<std::string>{left.error().text()};
}

constexpr char kFive[] =
    "[[case]]\nname = \"a\"\ntags = [\"slow\"]\n[[case]]\nname = \"b\"\n"
    "[[case]]\nname = \"c\"\ntags = [\"slow\", \"arm\"]\n[[case]]\nname = \"d\"\n"
    "[[case]]\nname = \"e\"\ncamera = [\"top\", \"far side\"]\n";

TEST(SuitePlan, SeveralCamerasGiveAFrameEach) {
  const Suite suite = suiteOf(kFive);
  const auto frames = planFrames(suite, nullptr);
  ASSERT_TRUE(frames.ok());
  EXPECT_THAT(namesOf(*frames), ElementsAre("a", "b", "c", "d", "e.top", "e.far_side"));
  EXPECT_EQ(frames->back().camera, "far side");
  EXPECT_EQ(frames->back().case_name, "e");
}

TEST(SuitePlan, TwoFramesOfOneNameAreRefused) {
  const Suite suite = suiteOf(
      "[[case]]\nname = \"a.top\"\n[[case]]\nname = \"a\"\n"
      "camera = [\"top\", \"side\"]\n");
  const auto frames = planFrames(suite, nullptr);
  ASSERT_FALSE(frames.ok());
  EXPECT_EQ(frames.error().text(),
            "two frames would be named `a.top`; the other comes from line 3 (s.toml:5)");
}

TEST(SuitePlan, SelectsByNameCaseAndTag) {
  const Suite suite = suiteOf(kFive);
  EXPECT_THAT(selected(suite, {.only = {"e"}}), ElementsAre("e.top", "e.far_side"));
  EXPECT_THAT(selected(suite, {.only = {"*.top", "b"}}), ElementsAre("b", "e.top"));
  EXPECT_THAT(selected(suite, {.tags = {"slow"}}), ElementsAre("a", "c"));
  EXPECT_THAT(selected(suite, {.tags = {"slow"}, .not_tags = {"arm"}}), ElementsAre("a"));
  EXPECT_THAT(selected(suite, {.only = {"x"}}),
              ElementsAre("no case is selected, so nothing would be judged (s.toml)"));
}

TEST(SuitePlan, ShardsTogetherAreTheWholeAndShareNothing) {
  const Suite suite = suiteOf(kFive);
  for (int shards = 1; shards <= 5; ++shards) {
    std::vector<std::string> all;
    for (int shard = 1; shard <= shards; ++shard) {
      const auto part = selected(suite, {.shard = shard, .shards = shards});
      EXPECT_EQ(part, selected(suite, {.shard = shard, .shards = shards}));
      all.insert(all.end(), part.begin(), part.end());
    }
    EXPECT_THAT(all, testing::UnorderedElementsAreArray(selected(suite, {}))) << shards;
  }
  EXPECT_THAT(selected(suite, {.shard = 6, .shards = 6}),
              ElementsAre("shard 6/6 is empty: with 5 cases, ask for at most 5 shards "
                          "(s.toml)"));
}

TEST(ParseShard, TakesIOfNAlone) {
  EXPECT_EQ(*parseShard("2/5"), std::pair(2, 5));
  for (const char* wrong : {"", "2", "0/5", "6/5", "2/5x", "/5", "2/", "-1/5", "1/99999"}) {
    EXPECT_FALSE(parseShard(wrong).ok()) << wrong;
  }
}

TEST(InLogOrder, SortsByTimeAndKeepsTiesInOrder) {
  std::vector<SuiteFrame> frames(4);
  frames[0].time = LogTime(Nanoseconds(30));
  frames[1].time = LogTime(Nanoseconds(10));
  frames[2].time = LogTime(Nanoseconds(10));
  EXPECT_THAT(inLogOrder(frames), ElementsAre(3, 1, 2, 0));  // without a moment: nothing to draw
}

}  // namespace
}  // namespace rocinante
