#include "player/playhead/restatement_schedule.h"

#include <gtest/gtest.h>

#include <chrono>

#include "core/packet/packet.h"
#include "player/playhead/lockstep.h"

namespace rocinante {
namespace {

SteadyTime afterMs(int milliseconds) {
  return SteadyTime(std::chrono::seconds(1000) + std::chrono::milliseconds(milliseconds));
}

/// To one route; nothing is in the state, so that a restatement is of the sources alone.
struct Scheduled {
  PlayRoutes routes{{Route{}}, {}, {}, {0}};
  SessionState state;
  RestatementSchedule schedule;
  explicit Scheduled(Nanoseconds repeat) : schedule(routes, repeat, 1200) {}
  void begin(SteadyTime now) { schedule.begin(state, {"arm", "gantry"}, "player1", now); }
};

TEST(RestatementSchedule, IsDueARepeatAfterTheOneBefore) {
  Scheduled one{std::chrono::seconds(2)};
  one.begin(afterMs(0));
  EXPECT_TRUE(one.schedule.isSending());
  EXPECT_FALSE(one.schedule.isDue(afterMs(1999)));
  EXPECT_TRUE(one.schedule.isDue(afterMs(2000)));
  one.schedule.postpone(afterMs(1000));
  EXPECT_FALSE(one.schedule.isDue(afterMs(2000)));
  EXPECT_TRUE(one.schedule.isDue(afterMs(3000)));
}

TEST(RestatementSchedule, EachDatagramSentPutsTheNextOneOff) {
  Scheduled one{std::chrono::seconds(2)};
  one.begin(afterMs(0));
  while (one.schedule.isSending()) {
    EXPECT_EQ(one.schedule.route(), 0);
    const ByteView datagram = one.schedule.take(afterMs(1000));
    EXPECT_NE(textOf(datagram).find("by=player"), std::string_view::npos) << textOf(datagram);
  }
  EXPECT_FALSE(one.schedule.isDue(afterMs(2000)));
  EXPECT_TRUE(one.schedule.isDue(afterMs(3000)));
}

TEST(RestatementSchedule, NoRepeatIsNeverDue) {
  Scheduled one{Nanoseconds(0)};
  EXPECT_FALSE(one.schedule.isDue(afterMs(0)));
  one.begin(afterMs(0));
  EXPECT_FALSE(one.schedule.isDue(afterMs(3600000)));
}

TEST(RestatementSchedule, ANewOneTakesTheOldOnesPlace) {
  Scheduled one{std::chrono::seconds(2)};
  one.begin(afterMs(0));
  one.begin(afterMs(10));
  EXPECT_EQ(one.schedule.askedAt(), afterMs(10));
  one.schedule.clear(afterMs(20));
  EXPECT_FALSE(one.schedule.isSending());
  EXPECT_FALSE(one.schedule.isDue(afterMs(2000)));
}

TEST(Lockstep, WaitsForAnyWordThenForEachMessage) {
  Lockstep lockstep(true);
  EXPECT_EQ(lockstep.awaited(), 0U);
  lockstep.hear();
  EXPECT_FALSE(lockstep.isWaiting());
  lockstep.send(7);
  lockstep.hear();
  EXPECT_EQ(lockstep.awaited(), 7U);
  EXPECT_EQ(lockstep.acknowledge(8).error().what, "step 8 has not been sent yet");
  EXPECT_TRUE(lockstep.acknowledge(6));
  EXPECT_TRUE(lockstep.isWaiting());
  EXPECT_TRUE(lockstep.acknowledge(7));
  EXPECT_FALSE(lockstep.isWaiting());
}

TEST(Lockstep, IsNeverWaitedForWhereItIsOff) {
  Lockstep lockstep(false);
  lockstep.send(1);
  EXPECT_FALSE(lockstep.isWaiting());
  EXPECT_EQ(lockstep.acknowledge(1).error().what, "ack is for --lockstep only");
}

}  // namespace
}  // namespace rocinante
