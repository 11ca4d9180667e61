#include "player/send/pacing.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using Action = Pacing::Action;

SteadyTime at(Nanoseconds time) { return SteadyTime(time); }

TEST(Pacing, SleepsThenSpinsThenSends) {
  const Pacing pacing;
  const auto deadline = at(10ms);
  const auto sleep = pacing.step(at(1ms), deadline);
  EXPECT_EQ(sleep.action, Action::sleep);
  EXPECT_EQ(sleep.until, deadline - Pacing::kFirstSpin);
  EXPECT_EQ(pacing.step(deadline - Pacing::kFirstSpin, deadline).action, Action::spin);
  EXPECT_EQ(pacing.step(deadline - 1ns, deadline).action, Action::spin);
  EXPECT_EQ(pacing.step(deadline, deadline).action, Action::send);
  EXPECT_EQ(pacing.step(deadline + 1h, deadline).action, Action::send);
}

TEST(Pacing, LearnsHowLateTimersWake) {
  Pacing pacing;
  for (int i = 0; i < 10'000; ++i) pacing.woke(at(1s), at(1s + 5us));
  EXPECT_EQ(pacing.spin(), Pacing::kLeastSpin);
  for (int i = 0; i < 100; ++i) pacing.woke(at(1s), at(1s + 200us));
  EXPECT_GE(pacing.spin(), 200us);
  EXPECT_LE(pacing.spin(), 220us);
  // One in a thousand is not worth it.
  for (int i = 0; i < 100'000; ++i) pacing.woke(at(1s), at(1s + (i % 1'000 == 0 ? 2ms : 5us)));
  EXPECT_LE(pacing.spin(), 60us);
  // Nor are machines that are stopped for seconds.
  for (int i = 0; i < 1'000; ++i) pacing.woke(at(1s), at(1h));
  EXPECT_EQ(pacing.spin(), Pacing::kMaxSpin);
}

TEST(Pacing, WokenByACommandIsNotLate) {
  Pacing pacing;
  const Nanoseconds before = pacing.spin();
  pacing.woke(at(1s), at(10ms));
  EXPECT_EQ(pacing.spin(), before);
}

TEST(Pacing, NeverSleepsSoLongThatAStopWaits) {
  const auto step = Pacing().step(at(0s), at(1h));
  EXPECT_EQ(step.action, Action::sleep);
  EXPECT_EQ(step.until, at(Pacing::kLongestSleep));
}

TEST(Pacing, SpinsLessThanHalfOfTheTimeAtAnyRate) {
  for (const int rate : {10, 1'000, 6'000, 8'000, 20'000, 100'000}) {
    SCOPED_TRACE(rate);
    Pacing pacing;
    for (int i = 0; i < 2000; ++i) pacing.sent(at(i * 1'000'000'000ns / rate));
    for (int i = 0; i < 2000; ++i) pacing.woke(at(1s), at(1s + 1ms));
    EXPECT_LT(pacing.spin() * rate, 400ms);
    if (rate <= 1'000) {
      EXPECT_EQ(pacing.spin(), Pacing::kMaxSpin);
    }
    if (rate <= 6'000) {
      EXPECT_GE(pacing.spin(), 59us);
    }
    if (rate >= 20'000) {
      EXPECT_EQ(pacing.spin(), 0ns);
    }
    const auto deadline = at(1h);
    EXPECT_EQ(pacing.step(deadline - pacing.spin() / 2 - 1ns, deadline).action,
              pacing.spin() > 0ns ? Action::spin : Action::sleep);
    EXPECT_EQ(pacing.step(deadline - pacing.spin() - 1ns, deadline).action, Action::sleep);
  }
}

TEST(Pacing, SpinsAgainWhenABurstIsOver) {
  Pacing pacing;
  SteadyTime deadline{};
  for (int i = 0; i < 1000; ++i) pacing.sent(deadline += 10us);
  EXPECT_EQ(pacing.spin(), 0ns);
  for (int i = 0; i < 10; ++i) pacing.sent(deadline += 1h);
  EXPECT_GE(pacing.spin(), 45us);
}

TEST(Pacing, ALongPauseDoesNotHideTheBurstAfterIt) {
  Pacing pacing;
  SteadyTime deadline{};
  pacing.sent(deadline);
  pacing.sent(deadline += 24h);
  int steps = 0;
  for (; pacing.spin() > 0us && steps < 10'000; ++steps) pacing.sent(deadline += 10us);
  // 64 steps of averaging bring 1 ms down to 60 us in a few hundred.
  EXPECT_LT(steps, 600);
}

TEST(Pacing, DatagramsDueTogetherNeedNoSpin) {
  Pacing pacing;
  for (int i = 0; i < 5'000; ++i) pacing.sent(at(1s));
  EXPECT_EQ(pacing.step(at(1s) - 1us, at(1s)).action, Action::sleep);
}

}  // namespace
}  // namespace rocinante
