#include "tests/bench/replay/replay_errors.h"

#include <gtest/gtest.h>

#include "tests/bench/replay/replay_schedule.h"

namespace rocinante::bench {
namespace {

using namespace std::chrono_literals;

std::vector<std::int64_t> arrivalsOf(const Schedule& schedule, const PlaybackSpeed& speed) {
  std::vector<std::int64_t> arrivals;
  for (const Nanoseconds due : schedule.due) {
    arrivals.push_back(1'000'000'000 + speed.realDuration(due).count());
  }
  return arrivals;
}

TEST(ReplayErrors, AReplayThatKeepsToItsScheduleHasNoneWheneverItBegan) {
  for (const char* text : {"0.1", "1", "3", "10"}) {
    const PlaybackSpeed speed = PlaybackSpeed::parse(text).value();
    const Schedule schedule = Schedule::poisson(1'000, 5'000);
    const ReplayErrors errors = replayErrors(schedule.due, arrivalsOf(schedule, speed), speed);
    EXPECT_EQ(errors.arrived, 5'000U);
    EXPECT_EQ(errors.max_us, 0);
    EXPECT_EQ(errors.drift_us, 0);
  }
}

TEST(ReplayErrors, EarlyCountsAsMuchAsLate) {
  const Schedule schedule = Schedule::regular(1'000, 1'000);
  auto arrivals = arrivalsOf(schedule, PlaybackSpeed());
  for (std::size_t i = 500; i < 1'000; ++i) arrivals[i] -= 70'000;
  arrivals[700] += 170'000;
  const ReplayErrors errors = replayErrors(schedule.due, arrivals, PlaybackSpeed());
  EXPECT_EQ(errors.p50_us, 0);
  EXPECT_EQ(errors.p99_us, 70);
  EXPECT_EQ(errors.max_us, 100);
  EXPECT_EQ(errors.drift_us, -70);
}

TEST(ReplayErrors, WhatNeverCameIsNoError) {
  const Schedule schedule = Schedule::regular(1'000, 1'000);
  auto arrivals = arrivalsOf(schedule, PlaybackSpeed());
  arrivals[0] = arrivals[500] = 0;
  EXPECT_EQ(replayErrors(schedule.due, arrivals, PlaybackSpeed()).arrived, 998U);
  EXPECT_EQ(replayErrors(schedule.due, std::vector<std::int64_t>(1'000), PlaybackSpeed()).arrived,
            0U);
}

TEST(ReplaySchedule, APayloadIsFoundByItsNumberBehindAnyHeader) {
  EXPECT_EQ(payloadOf(1'234'567).size(), 100U);
  EXPECT_EQ(numberOf(bytesOf(payloadOf(1'234'567))), 1'234'567);
  const std::string framed = "LC02" + payloadOf(7);
  EXPECT_EQ(numberOf(bytesOf(framed)), 7);
  EXPECT_EQ(numberOf(bytesOf(std::string("RK1 a - -\njoints a 1\n"))), -1);
  EXPECT_EQ(numberOf(bytesOf(std::string("\n#1234567x"))), -1);
}

TEST(ReplaySchedule, APoissonScheduleHasTheRateAndIsTheSameInEveryRun) {
  const Schedule schedule = Schedule::poisson(6'000, 60'000);
  EXPECT_NEAR(std::chrono::duration<double>(schedule.due.back()).count(), 10, 0.3);
  EXPECT_EQ(schedule.due, Schedule::poisson(6'000, 60'000).due);
}

}  // namespace
}  // namespace rocinante::bench
