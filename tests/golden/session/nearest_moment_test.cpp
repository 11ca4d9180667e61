#include <gtest/gtest.h>

#include "golden/session/session_comparison.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"

namespace rocinante {
namespace {

class NearestMoment : public testing::Test {
 protected:
  NearestMoment() {
    test::writeText(folder_ / "arm.urdf", test::kArmUrdf);
    auto cell = loadCell(folder_ / "arm.urdf", {});
    if (cell.ok()) cell_ = std::move(*cell);
  }
  Timeline session(const std::string& name,
                   const std::vector<std::pair<std::int64_t, std::string>>& packets) {
    test::writeSession(folder_ / name, packets);
    return std::move(*Timeline::open(folder_ / name));
  }
  /// In milliseconds, of candidates 0, 10 ... 100 ms.
  std::int64_t nearest(Timeline& a, Timeline& b, std::int64_t at_ms) {
    std::vector<LogTime> candidates;
    for (int ms = 0; ms <= 100; ms += 10) candidates.push_back(test::sessionTime(ms));
    const LogTime asked = test::sessionTime(at_ms);
    const auto found = nearestMoment(cell_, a, asked, b, asked, candidates, {});
    EXPECT_TRUE(found.ok());
    return (found.value_or(LogTime{}) - test::sessionTime(0)) / std::chrono::milliseconds(1);
  }

  test::TemporaryFolder folder_;
  Cell cell_;
};

TEST_F(NearestMoment, IsWhereTheJointsAreTheSame) {
  std::vector<std::pair<std::int64_t, std::string>> there, late;
  for (int i = 0; i <= 10; ++i) {
    there.emplace_back(i * 10, "joint arm turn=" + std::to_string(0.01 * i) + "\n");
    late.emplace_back(i * 10, "joint arm turn=" + std::to_string(0.01 * (i - 3)) + "\n");
  }
  Timeline a = session("a.mcap", there);
  Timeline b = session("b.mcap", late);
  EXPECT_EQ(nearest(a, b, 50), 80);
  EXPECT_EQ(nearest(b, a, 80), 50);
}

TEST_F(NearestMoment, WhatIsHiddenOutweighsWhereItIs) {
  Timeline a = session("a.mcap", {{0, "joint arm turn=0.5\n"}, {100, "joint arm turn=0.5\n"}});
  Timeline b = session("b.mcap", {{0, "joint arm turn=0.5\nhide arm\n"},
                                  {70, "joint arm turn=0.2\nshow arm\n"},
                                  {100, "joint arm turn=0.2\n"}});
  EXPECT_EQ(nearest(a, b, 50), 70);
}

TEST_F(NearestMoment, AmongEqualOnesIsTheNearestInTime) {
  Timeline a = session("a.mcap", {{0, "joint arm turn=0.5\n"}, {100, "joint arm turn=0.5\n"}});
  Timeline b = session("b.mcap", {{0, "joint arm turn=0.5\n"}, {100, "joint arm turn=0.5\n"}});
  EXPECT_EQ(nearest(a, b, 50), 50);
}

}  // namespace
}  // namespace rocinante
