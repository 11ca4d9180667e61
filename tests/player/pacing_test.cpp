#include "player/pacing.h"

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
  EXPECT_EQ(sleep.until, deadline - Pacing::kSpin);
  EXPECT_EQ(pacing.step(deadline - Pacing::kSpin, deadline).action, Action::spin);
  EXPECT_EQ(pacing.step(deadline - 1ns, deadline).action, Action::spin);
  EXPECT_EQ(pacing.step(deadline, deadline).action, Action::send);
  EXPECT_EQ(pacing.step(deadline + 1h, deadline).action, Action::send);
}

TEST(Pacing, NeverSleepsSoLongThatAStopWaits) {
  const auto step = Pacing().step(at(0s), at(1h));
  EXPECT_EQ(step.action, Action::sleep);
  EXPECT_EQ(step.until, at(Pacing::kLongestSleep));
}

TEST(Pacing, SpinsAtSixThousandASecondAndNotAtTwentyThousand) {
  Pacing slow;
  Pacing fast;
  for (int i = 0; i < 2000; ++i) {
    slow.sent(at(i * 1'000'000'000ns / 6'000));
    fast.sent(at(i * 1'000'000'000ns / 20'000));
  }
  EXPECT_TRUE(slow.spins());
  EXPECT_FALSE(fast.spins());
  const auto deadline = at(1h);
  EXPECT_EQ(slow.step(deadline - 30us, deadline).action, Action::spin);
  const auto asleep = fast.step(deadline - 30us, deadline);
  EXPECT_EQ(asleep.action, Action::sleep);
  EXPECT_EQ(asleep.until, deadline);
}

TEST(Pacing, SpinsAgainWhenABurstIsOver) {
  Pacing pacing;
  SteadyTime deadline{};
  for (int i = 0; i < 1000; ++i) pacing.sent(deadline += 10us);
  EXPECT_FALSE(pacing.spins());
  for (int i = 0; i < 10; ++i) pacing.sent(deadline += 1h);
  EXPECT_TRUE(pacing.spins());
}

TEST(Pacing, ALongPauseDoesNotHideTheBurstAfterIt) {
  Pacing pacing;
  SteadyTime deadline{};
  pacing.sent(deadline);
  pacing.sent(deadline += 24h);
  int spun = 0;
  for (; pacing.spins() && spun < 10'000; ++spun) pacing.sent(deadline += 10us);
  // 64 steps of averaging bring 10 ms below 120 us in a few hundred.
  EXPECT_LT(spun, 400);
}

}  // namespace
}  // namespace rocinante
