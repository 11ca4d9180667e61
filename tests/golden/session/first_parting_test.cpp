#include <gtest/gtest.h>

#include <set>

#include "golden/session/bisect.h"

namespace rocinante {
namespace {

/// Differs at these moments.
PartingQuestion questionOf(std::size_t moments, std::set<std::size_t> differing) {
  PartingQuestion question;
  question.moments = moments;
  question.differs = [differing = std::move(differing)](std::size_t moment) -> Result<bool> {
    return differing.contains(moment);
  };
  return question;
}

TEST(FindParting, FindsTheFirstSinceTheLastProbeThatIsAlike) {
  auto question = questionOf(100, {37, 38, 39, 60, 61, 62, 63, 64});
  question.probes = {20, 40, 60};
  const auto parting = findParting(question);
  ASSERT_TRUE(parting.ok());
  // 37 lies between two probes that are alike: only what lies before a probe that differs is seen.
  EXPECT_EQ(parting->first, 60U);
  EXPECT_TRUE(parting->is_first_since_probe);
  EXPECT_EQ(parting->searched_from, 41U);
  EXPECT_EQ(parting->last_alike, 59U);
}

TEST(FindParting, HalvesWhatIsTooLong) {
  std::set<std::size_t> differing;
  for (std::size_t moment = 6543; moment < 10'000; ++moment) differing.insert(moment);
  auto question = questionOf(10'000, differing);
  question.most_frames = 100;
  const auto parting = findParting(question);
  ASSERT_TRUE(parting.ok());
  EXPECT_EQ(parting->first, 6543U);
  EXPECT_FALSE(parting->is_first_since_probe);
  EXPECT_LT(parting->frames, 20U);
}

TEST(FindParting, NothingToFindIsNoParting) {
  EXPECT_FALSE(findParting(questionOf(50, {}))->first.has_value());
  EXPECT_FALSE(findParting(questionOf(0, {}))->first.has_value());
  EXPECT_EQ(findParting(questionOf(50, {0, 49}))->first, 0U);
}

}  // namespace
}  // namespace rocinante
