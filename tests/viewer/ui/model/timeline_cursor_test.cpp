#include "viewer/ui/model/timeline_cursor.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

using namespace std::chrono_literals;

constexpr LogTime kStart{1000s};
constexpr LogTime kEnd{1020s};

SteadyTime at(Nanoseconds since) { return SteadyTime(since); }

TEST(TimelineCursor, StandsStillUntilItPlays) {
  TimelineCursor cursor(kStart, kEnd);
  EXPECT_EQ(cursor.position(at(5s)), kStart);
  cursor.play(at(5s));
  EXPECT_EQ(cursor.position(at(7s)), kStart + 2s);
  cursor.pause(at(8s));
  EXPECT_EQ(cursor.position(at(100s)), kStart + 3s);
}

TEST(TimelineCursor, StopsAtTheEndAndBeginsAnewFromThere) {
  TimelineCursor cursor(kStart, kEnd);
  cursor.play(at(0s));
  EXPECT_EQ(cursor.position(at(21s)), kEnd);
  EXPECT_FALSE(cursor.playing());
  cursor.play(at(30s));
  EXPECT_EQ(cursor.position(at(31s)), kStart + 1s);
}

TEST(TimelineCursor, LoopsWithoutLosingTime) {
  TimelineCursor cursor(kStart, kEnd);
  cursor.setLooping(true);
  cursor.play(at(0s));
  EXPECT_EQ(cursor.position(at(23s)), kStart + 3s);
  EXPECT_TRUE(cursor.playing());
  EXPECT_EQ(cursor.position(at(24s)), kStart + 4s);
}

TEST(TimelineCursor, ChangesSpeedWithoutAJump) {
  TimelineCursor cursor(kStart, kEnd);
  cursor.play(at(0s));
  EXPECT_TRUE(cursor.setSpeed("2", at(3s)));
  EXPECT_EQ(cursor.position(at(3s)), kStart + 3s);
  EXPECT_EQ(cursor.position(at(4s)), kStart + 5s);
  EXPECT_FALSE(cursor.setSpeed("fast", at(4s)));
  EXPECT_EQ(cursor.speedText(), "2");
}

TEST(TimelineCursor, AThirdOfASecondAtAThirdOfTheSpeedIsExact) {
  TimelineCursor cursor(kStart, kStart + 2h);
  ASSERT_TRUE(cursor.setSpeed("1/3", at(0s)));
  cursor.play(at(0s));
  EXPECT_EQ(cursor.position(at(1h)), kStart + 20min);
}

TEST(TimelineCursor, SeeksWithinTheLogAndGoesOn) {
  TimelineCursor cursor(kStart, kEnd);
  cursor.play(at(0s));
  cursor.seek(kStart + 10s, at(1s));
  EXPECT_EQ(cursor.position(at(2s)), kStart + 11s);
  cursor.seek(kStart - 5s, at(2s));
  EXPECT_EQ(cursor.position(at(2s)), kStart);
  cursor.step(-1s, at(3s));
  EXPECT_EQ(cursor.position(at(9s)), kStart);
  cursor.step(90s, at(9s));
  EXPECT_EQ(cursor.position(at(9s)), kEnd);
}

TEST(TimelineCursor, ALogOfOneMomentNeitherMovesNorDividesByZero) {
  TimelineCursor cursor(kStart, kStart);
  cursor.setLooping(true);
  cursor.play(at(0s));
  EXPECT_EQ(cursor.position(at(1s)), kStart);
}

}  // namespace
}  // namespace rocinante
