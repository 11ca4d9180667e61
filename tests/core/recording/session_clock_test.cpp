#include "core/recording/session_clock.h"

#include <gtest/gtest.h>

#include "tests/core/recording/fake_clocks.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::FakeClocks;
using test::logTime;

TEST(SessionClock, BeginsAtTheWallTimeOfTheFirstLook) {
  const FakeClocks clocks;
  const SessionClock clock(clocks.look());
  EXPECT_EQ(clock.now(), logTime(0ns));
}

TEST(SessionClock, KeepsKernelStampsToTheNanosecond) {
  FakeClocks clocks;
  SessionClock clock(clocks.look());
  const WallTime stamp = clocks.wall() + 12'345ns;
  clocks.pass(1ms);
  EXPECT_FALSE(clock.observe(clocks.look()));
  EXPECT_EQ(clock.at(stamp), logTime(12'345ns));
}

TEST(SessionClock, TheNoiseOfALookMovesNothing) {
  FakeClocks clocks;
  SessionClock clock(clocks.look());
  for (int i = 0; i < 100; ++i) {
    clocks.pass(1ms);
    ClockReading reading = clocks.look();
    reading.wall += Nanoseconds(i % 2 == 0 ? 40 : -40);
    EXPECT_FALSE(clock.observe(reading));
    EXPECT_EQ(clock.at(clocks.wall()), logTime(1ms * (i + 1)));
  }
}

TEST(SessionClock, TellsAStepOverAMillisecondAndIsNotBentByIt) {
  for (const Nanoseconds step : {Nanoseconds(5ms), Nanoseconds(-5ms), Nanoseconds(3600s),
                                 Nanoseconds(-3600s), Nanoseconds(1'000'200ns)}) {
    SCOPED_TRACE(step.count());
    FakeClocks clocks;
    SessionClock clock(clocks.look());
    clocks.pass(10ms);
    EXPECT_FALSE(clock.observe(clocks.look()));

    clocks.pass(400us);
    const WallTime before_step = clocks.wall();
    clocks.pass(100us);
    clocks.setWall(step);
    clocks.pass(100us);
    const WallTime after_step = clocks.wall();
    clocks.pass(400us);
    const auto noticed = clock.observe(clocks.look());
    ASSERT_TRUE(noticed);
    EXPECT_EQ(noticed->step, step);
    EXPECT_EQ(noticed->at, logTime(11ms));

    if (std::chrono::abs(step) > 1100us) {
      EXPECT_EQ(clock.at(before_step), logTime(10'400us));
    }
    EXPECT_EQ(clock.at(after_step), logTime(10'600us));
    clocks.pass(1s);
    EXPECT_FALSE(clock.observe(clocks.look()));
    EXPECT_EQ(clock.at(clocks.wall()), logTime(1011ms));
  }
}

TEST(SessionClock, FollowsASmallMoveInSilence) {
  FakeClocks clocks;
  SessionClock clock(clocks.look());
  clocks.pass(1s);
  clocks.setWall(900us);
  EXPECT_FALSE(clock.observe(clocks.look()));
  EXPECT_EQ(clock.at(clocks.wall()), logTime(1s));
}

TEST(SessionClock, PassesOverALookThatWasInterrupted) {
  FakeClocks clocks;
  SessionClock clock(clocks.look());
  clocks.pass(1s);
  ClockReading interrupted = clocks.look();
  interrupted.before -= 8ms;  // 4 ms off in the middle
  EXPECT_FALSE(clock.observe(interrupted));
  EXPECT_EQ(clock.at(clocks.wall()), logTime(1s));
}

TEST(SessionClock, AStampFromTheFutureIsNow) {
  FakeClocks clocks;
  SessionClock clock(clocks.look());
  clocks.pass(1ms);
  clock.observe(clocks.look());
  EXPECT_EQ(clock.at(clocks.wall() + 1h), clock.now());
}

}  // namespace
}  // namespace rocinante
