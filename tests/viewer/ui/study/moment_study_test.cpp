#include "viewer/ui/study/moment_study.h"

#include <gtest/gtest.h>

#include <atomic>

#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

TEST(MomentStudy, PosesTheCellAtAnyMoment) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "arm.urdf", test::kArmUrdf);
  test::writeSession(folder / "s.mcap",
                     {{0, "pose arm 1 0 0 0 0 0 1\n"}, {1000, "pose arm 2 0 0 0 0 0 1\n"}});
  const auto cell = loadCell(folder / "arm.urdf", {});
  ASSERT_TRUE(cell.ok());
  const auto timeline = Timeline::open(folder / "s.mcap");
  ASSERT_TRUE(timeline.ok());
  std::atomic<int> ready = 0;
  MomentStudy study(*cell, [&] { ++ready; });
  EXPECT_EQ(study.scene(), nullptr);
  for (const auto& [since, x] : {std::pair(1000ms, 2.0), std::pair(500ms, 1.0)}) {
    study.ask(folder / "s.mcap", timeline->start() + since);
    study.wait();
    ASSERT_NE(study.scene(), nullptr);
    ASSERT_EQ(study.scene()->devices.size(), 1U);
    EXPECT_EQ(study.scene()->devices[0].link_world[0][3].x, x);
  }
  study.ask(folder / "nowhere.mcap", timeline->start());
  study.wait();
  EXPECT_EQ(study.scene(), nullptr);
}

}  // namespace
}  // namespace rocinante
