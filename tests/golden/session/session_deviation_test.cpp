#include "golden/session/session_deviation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/session/timeline.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"

namespace rocinante {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

class CompareSessions : public testing::Test {
 protected:
  CompareSessions() {
    test::writeText(folder_ / "arm.urdf", test::kArmUrdf);
    auto cell = loadCell(folder_ / "arm.urdf", {});
    if (cell.ok()) cell_ = std::move(*cell);
  }
  /// The arm turns by 0.01 rad a packet, each `step_ms`, from 0; `off` from 500 ms of it on.
  Timeline session(const std::string& name, std::int64_t step_ms, std::int64_t late_ms,
                   double off) {
    std::vector<std::pair<std::int64_t, std::string>> packets = {{0, "event \"go\"\n"}};
    for (int i = 1; i < 100; ++i) {
      const double q = i * 0.01 + (i >= 50 ? off : 0);
      packets.emplace_back(i * step_ms + late_ms, "joint arm turn=" + std::to_string(q) + "\n");
    }
    packets.emplace_back(100 * step_ms, "event \"stop\"\n");
    test::writeSession(folder_ / name, packets);
    return std::move(*Timeline::open(folder_ / name));
  }
  SessionDeviation compareThem(Timeline a, Timeline b) {
    const auto events_a = a.events();
    const auto events_b = b.events();
    const auto alignment = alignEvents(**events_a, **events_b, a.start(), b.start());
    StateDamage damage;
    auto found = compareSessions(cell_, a, b, alignment, {}, damage);
    EXPECT_TRUE(damage.empty());
    EXPECT_TRUE(found.ok());
    return found.ok() ? *found : SessionDeviation{};
  }

  test::TemporaryFolder folder_;
  Cell cell_;
};

TEST_F(CompareSessions, LatePacketsAndAnotherPaceAreNoDifference) {
  const auto found = compareThem(session("a.mcap", 10, 0, 0), session("b.mcap", 20, 7, 0));
  EXPECT_GT(found.samples, 40U);
  EXPECT_THAT(found.beyond, IsEmpty());
}

TEST_F(CompareSessions, AJointThatGoesElsewhereIsNamedWithItsTime) {
  const auto found = compareThem(session("a.mcap", 10, 0, 0), session("b.mcap", 10, 0, 0.2));
  ASSERT_THAT(found.beyond, SizeIs(1));
  EXPECT_EQ(found.beyond[0].item, "arm/turn");
  EXPECT_EQ(found.beyond[0].unit, "rad");
  EXPECT_NEAR(*found.beyond[0].largest, 0.2, 0.06);  // less what comes within the slack
  EXPECT_NEAR(
      std::chrono::duration<double>(found.beyond[0].first_at - test::sessionTime(0)).count(), 0.5,
      0.07);
}

TEST_F(CompareSessions, WhatOneSessionNeverSaysIsNotTheSame) {
  test::writeSession(folder_ / "a.mcap", {{0, "joint arm turn=1\n"}, {1000, "joint arm turn=1\n"}});
  test::writeSession(folder_ / "b.mcap",
                     {{0, "joint arm turn=1\nhide arm\n"}, {1000, "joint arm turn=1\n"}});
  const auto found = compareThem(std::move(*Timeline::open(folder_ / "a.mcap")),
                                 std::move(*Timeline::open(folder_ / "b.mcap")));
  ASSERT_THAT(found.beyond, SizeIs(1));
  EXPECT_EQ(found.beyond[0].item, "show arm");
  EXPECT_FALSE(found.beyond[0].largest.has_value());
}

}  // namespace
}  // namespace rocinante
