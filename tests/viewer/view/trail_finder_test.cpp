#include "viewer/view/trail_finder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math/transform.h"
#include "tests/core/session/seconds_log.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"
#include "viewer/view/frame_extras.h"

namespace rocinante {
namespace {

using test::sessionTime;

/// The arm of test_session.h, its hand a metre from the axis that it turns about.
class TrailFinderTest : public testing::Test {
 protected:
  void open(const std::vector<std::pair<std::int64_t, std::string>>& packets) {
    test::writeText(folder_.path() / "arm.urdf", test::kArmUrdf);
    test::writeText(folder_.path() / "cell.toml", R"(format = 1
[[device]]
name = "arm"
model = "arm.urdf"
[[device]]
name = "tool"
model = "arm.urdf"
on = "arm/hand"
[[source]]
name = "robot"
ghost_of = { plan = "arm" }
)");
    test::writeSession(folder_.path() / "s.mcap", packets);
    auto cell = loadCell(folder_.path() / "cell.toml", {});
    ASSERT_TRUE(cell.has_value()) << cell.error().text();
    cell_ = std::move(*cell);
  }
  Timeline session() {
    auto opened = Timeline::open(folder_.path() / "s.mcap");
    EXPECT_TRUE(opened.has_value());
    return std::move(*opened);
  }
  static std::vector<std::pair<std::int64_t, std::string>> turning() {
    std::vector<std::pair<std::int64_t, std::string>> packets;
    for (int i = 0; i <= 1000; ++i) {
      packets.emplace_back(i * 10, "pose arm " + std::to_string(i * 0.001) + " 0 0 0 0 0 1\n");
    }
    return packets;
  }

  test::TemporaryFolder folder_;
  Cell cell_;
};

using Runs = std::vector<std::vector<Trail::Point>>;

Runs trailOf(TrailFinder& finder, Timeline& session, const std::string& path, std::int64_t ms,
             Nanoseconds window = std::chrono::seconds(2)) {
  StateDamage damage;
  const auto trails = finder.find({{path, window}}, session, sessionTime(ms), damage);
  EXPECT_TRUE(damage.empty());
  EXPECT_TRUE(trails.has_value()) << (trails ? "" : trails.error().text());
  return trails ? trails->at(0).runs : Runs{};
}

TEST_F(TrailFinderTest, EndsWhereTheLinkIsAndBeginsAtTheWindowsEnd) {
  open(turning());
  TrailFinder finder(cell_);
  Timeline log = session();
  const Runs runs = trailOf(finder, log, "arm", 5'004);
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_LE(runs[0].size(), static_cast<std::size_t>(TrailFinder::kTrailPoints + 1));
  EXPECT_GT(runs[0].size(), 200U);
  EXPECT_EQ(runs[0].back().at.x, 0.5);
  EXPECT_EQ(runs[0].back().fresh, 1);
  EXPECT_NEAR(runs[0].front().at.x, 0.3, 0.002);
  EXPECT_LT(runs[0].front().fresh, 0.01F);
  for (std::size_t i = 1; i < runs[0].size(); ++i) {
    EXPECT_GE(runs[0][i].at.x, runs[0][i - 1].at.x);
  }
}

TEST_F(TrailFinderTest, IsTheSameAfterPlayingSeekingAndAlone) {
  open(turning());
  TrailFinder played(cell_);
  Timeline played_log = session();
  std::map<std::int64_t, Runs> seen;
  for (std::int64_t ms = 0; ms <= 10'000; ms += 410) {
    seen[ms] = trailOf(played, played_log, "arm/base", ms);
  }
  TrailFinder sought(cell_);
  Timeline sought_log = session();
  for (const std::int64_t ms : {8'200, 410, 4'920, 4'510, 9'840}) {
    TrailFinder alone(cell_);
    Timeline alone_log = session();
    EXPECT_EQ(trailOf(sought, sought_log, "arm/base", ms), seen[ms]);
    EXPECT_EQ(trailOf(alone, alone_log, "arm/base", ms), seen[ms]);
  }
}

TEST_F(TrailFinderTest, FollowsWhatCarriesALinkAndAGhost) {
  auto packets = turning();
  packets[300].second += "joint plan turn=0.5\n";
  open(packets);
  TrailFinder finder(cell_);
  Timeline log = session();
  EXPECT_EQ(trailOf(finder, log, "tool/base", 6'000).at(0).back().at.x, 0.6);
  const Runs ghost = trailOf(finder, log, "plan", 4'000);
  ASSERT_EQ(ghost.size(), 1U) << "it was not there before 3 s";
  EXPECT_GE(ghost[0].front().at.x, 0.3);
  EXPECT_EQ(ghost[0].back().at.x, 0.4);
}

TEST_F(TrailFinderTest, ADeviceThatLeftLeavesAGap) {
  auto packets = turning();
  packets[400].second += "remove arm\n";
  for (std::size_t i = 401; i < 450; ++i) packets[i].second = "event \"away\"\n";
  packets[450].second = "add arm arm.urdf\n" + packets[450].second;
  open(packets);
  TrailFinder finder(cell_);
  Timeline log = session();
  const Runs runs = trailOf(finder, log, "arm", 5'000);
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_LT(runs[0].back().at.x, 0.4001);
  EXPECT_GE(runs[1].front().at.x, 0.45);
}

TEST_F(TrailFinderTest, WhatIsNotThereOrAtNoPlaceHasNoTrail) {
  open({{0, "pose arm 1e308 0 0 0 0 0 1\n"}, {1000, "pose arm 1 0 0 0 0 0 1\n"}});
  TrailFinder finder(cell_);
  Timeline log = session();
  EXPECT_TRUE(trailOf(finder, log, "nobody", 1'000).empty());
  EXPECT_TRUE(trailOf(finder, log, "arm/nothing", 1'000).empty());
  EXPECT_EQ(trailOf(finder, log, "arm", 0).at(0).size(), 1U) << "the window begins with the log";
  EXPECT_EQ(trailOf(finder, log, "arm", 1'000, std::chrono::nanoseconds(1)).at(0).back().at.x, 1);
}

TEST(LimitLevels, NearIsTheLastTwentiethOfTheRangeAndBeyondIsPastIt) {
  JointLimits limits;
  limits.lower = -1;
  limits.upper = 3;
  EXPECT_EQ(limitLevel(limits, 0), LimitLevel::inside);
  EXPECT_EQ(limitLevel(limits, 2.79), LimitLevel::inside);
  EXPECT_EQ(limitLevel(limits, 2.81), LimitLevel::near);
  EXPECT_EQ(limitLevel(limits, -1), LimitLevel::near);
  EXPECT_EQ(limitLevel(limits, 3 + 1e-9), LimitLevel::near) << "rounding is no fault";
  EXPECT_EQ(limitLevel(limits, 3.001), LimitLevel::beyond);
  EXPECT_EQ(limitLevel(limits, std::nan("")), LimitLevel::beyond);
  limits.upper = -1;
  EXPECT_EQ(limitLevel(limits, 5), LimitLevel::inside) << "no range, no limit";
}

TEST_F(TrailFinderTest, TellsOfDamageInItsWindowAlsoOfPlacesThatItKnows) {
  test::SecondsLog log({0, 6});
  log.spoil(3);
  Timeline session = Timeline::of(test::openLog(log.file));
  TrailFinder finder(cell_);
  for (int turn = 0; turn < 2; ++turn) {
    for (const int seconds : {1, 5, 1}) {
      StateDamage damage;
      const TrailStyle style{"arm/hand", std::chrono::seconds(seconds)};
      ASSERT_TRUE(finder.find({style}, session, test::SecondsLog::moment(8000), damage).ok());
      EXPECT_EQ(!damage.empty(), seconds == 5) << turn;
    }
  }
}

}  // namespace
}  // namespace rocinante
