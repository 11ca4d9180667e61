#include "recorder/pieces/finding_trigger.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <thread>

#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr LogTime kTriggerStart{1000s};

Cell limitedArm(const std::filesystem::path& folder) {
  std::ofstream(folder / "arm.urdf")
      << "<robot name=\"arm\"> <link name=\"base\"/> <link name=\"hand\"/> <joint name=\"turn\" "
         "type=\"revolute\"> <parent link=\"base\"/> <child link=\"hand\"/> <limit lower=\"-2\" "
         "upper=\"2\" effort=\"1\" velocity=\"9\"/> </joint> </robot>";
  return loadCell(folder / "arm.urdf", {}).value();
}

void addJoint(FindingTrigger& trigger, int number, double value) {
  const std::string text = fmt::format("RK1 me@a {} -\njoints arm {}\n", number, value);
  trigger.add(kTriggerStart + 10ms * number, "rk1", true, bytesOf(text));
}

TEST(FindingTrigger, OfAFileTellsAtOnceInItsOwnTime) {
  const test::TemporaryFolder folder;
  FindingTrigger trigger(limitedArm(folder.path()), Severity::error, /*is_live=*/false);
  for (int i = 0; i < 100; ++i) addJoint(trigger, i, i >= 50 && i < 60 ? 3 : 1);
  const auto begun = trigger.take();
  ASSERT_THAT(begun, SizeIs(1));
  EXPECT_EQ(begun[0].at, kTriggerStart + 500ms);
  EXPECT_THAT(begun[0].text, HasSubstr("arm/turn is outside its limits"));
  EXPECT_THAT(begun[0].text, HasSubstr("[joint.limit]"));
  EXPECT_THAT(trigger.take(), IsEmpty());
}

TEST(FindingTrigger, JudgesWhatDecodersMade) {
  for (const bool is_live : {false, true}) {
    const test::TemporaryFolder folder;
    FindingTrigger trigger(limitedArm(folder.path()), Severity::warning, is_live);
    for (int i = 0; i < 100; ++i) {
      const std::string made =
          fmt::format("RK1 decoded:d - {}\njoints arm {}\n", i, i == 50 ? 3 : 1);
      trigger.addMade(kTriggerStart + 10ms * i, "octets", bytesOf(made));
    }
    trigger.reach(kTriggerStart + 1s);
    trigger.finish();
    const auto begun = trigger.take();
    // Not that octets are no packets.
    ASSERT_THAT(begun, SizeIs(1));
    EXPECT_EQ(begun[0].at, kTriggerStart + 500ms);
    EXPECT_THAT(begun[0].text, HasSubstr("[joint.limit]"));
  }
}

TEST(FindingTrigger, LiveJudgesEverythingOnItsOwnThread) {
  const test::TemporaryFolder folder;
  FindingTrigger trigger(limitedArm(folder.path()), Severity::error, /*is_live=*/true);
  for (int i = 0; i < 1000; ++i) {
    addJoint(trigger, i, i == 700 ? 3 : 1);
    if (i % 7 == 0) trigger.reach(kTriggerStart + 10ms * i);
  }
  trigger.reach(kTriggerStart + 11s);
  trigger.finish();
  const auto begun = trigger.take();
  ASSERT_THAT(begun, SizeIs(1));
  EXPECT_EQ(begun[0].at, kTriggerStart + 7s);
  EXPECT_EQ(trigger.dropped(), 0U);
}

TEST(FindingTrigger, LessSevereFindingsAndTheCellsOwnFaultsTriggerNothing) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "cell.toml")
      << "format = 1\n[[device]]\nname = \"arm\"\nmodel = \"gone.urdf\"\n";
  FindingTrigger trigger(loadCell(folder.path() / "cell.toml", {}).value(), Severity::error, false);
  const std::string text = "RK1 me@a 5 -\nnonsense arm\n";
  trigger.add(kTriggerStart, "rk1", true, bytesOf(text));
  trigger.reach(kTriggerStart + 1s);
  EXPECT_THAT(trigger.take(), IsEmpty());
}

TEST(FindingTrigger, WhatDoesNotFitTheQueueIsCountedAndStopsNobody) {
  const test::TemporaryFolder folder;
  FindingTrigger trigger(limitedArm(folder.path()), Severity::error, true);
  // The thread is not told of any time: it takes nothing.
  const std::string text = "RK1 me@a - -\nlabel a \"" + std::string(60'000, 'x') + "\"\n";
  std::uint64_t added = 0;
  for (; added < 1'000; ++added) {
    trigger.add(kTriggerStart + 1ms * added, "rk1", true, bytesOf(text));
  }
  EXPECT_GT(trigger.dropped(), 700U);
  EXPECT_LT(trigger.dropped(), 750U);
}

TEST(FindingTrigger, ASilenceIsFoundThoughNothingArrives) {
  const test::TemporaryFolder folder;
  FindingTrigger trigger(limitedArm(folder.path()), Severity::warning, true);
  for (int i = 0; i < 100; ++i) addJoint(trigger, i, 1);
  for (LogTime now = kTriggerStart + 1s; now < kTriggerStart + 15s; now += 50ms) trigger.reach(now);
  trigger.finish();
  const auto begun = trigger.take();
  ASSERT_THAT(begun, SizeIs(1));
  EXPECT_THAT(begun[0].text, HasSubstr("[source.silence]"));
}

}  // namespace
}  // namespace rocinante
