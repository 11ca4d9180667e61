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

TEST(TimelineCursor, PlaysBackwardsToTheStart) {
  TimelineCursor cursor(kStart, kEnd);
  cursor.seek(kStart + 5s, at(0s));
  cursor.setReversed(true, at(0s));
  cursor.play(at(0s));
  EXPECT_EQ(cursor.position(at(2s)), kStart + 3s);
  cursor.setReversed(false, at(2s));
  EXPECT_EQ(cursor.position(at(3s)), kStart + 4s);
  cursor.setReversed(true, at(3s));
  EXPECT_EQ(cursor.position(at(8s)), kStart);
  EXPECT_FALSE(cursor.playing());
  cursor.play(at(9s));  // from the other end
  EXPECT_EQ(cursor.position(at(10s)), kEnd - 1s);
}

TEST(TimelineCursor, RepeatsAPartInEitherDirection) {
  TimelineCursor cursor(kStart, kEnd);
  cursor.setPart(kStart + 8s, kStart + 4s, at(0s));
  EXPECT_EQ(cursor.repeat(), Repeat::loop);
  EXPECT_EQ(cursor.partStart(), kStart + 4s);
  cursor.play(at(0s));
  EXPECT_EQ(cursor.position(at(0s)), kStart + 4s);  // was outside
  EXPECT_EQ(cursor.position(at(3s)), kStart + 7s);
  EXPECT_EQ(cursor.position(at(9s)), kStart + 5s);  // twice round
  cursor.setReversed(true, at(9s));
  EXPECT_EQ(cursor.position(at(11s)), kStart + 7s);
  cursor.clearPart(at(11s));
  EXPECT_EQ(cursor.position(at(19s)), kEnd - 1s);
  cursor.setPart(kStart, kStart, at(19s));
  EXPECT_FALSE(cursor.hasPart());
}

TEST(TimelineCursor, GoesToAndFro) {
  TimelineCursor cursor(kStart, kEnd);
  cursor.setRepeat(Repeat::there_and_back, at(0s));
  cursor.play(at(0s));
  EXPECT_EQ(cursor.position(at(19s)), kStart + 19s);
  EXPECT_EQ(cursor.position(at(25s)), kStart + 15s);
  EXPECT_TRUE(cursor.reversed());
  EXPECT_EQ(cursor.position(at(41s)), kStart + 1s);
  EXPECT_FALSE(cursor.reversed());
  // Several turns at once, as after a frame that took long.
  EXPECT_EQ(cursor.position(at(41s + 200s + 20s)), kEnd - 1s);
  EXPECT_TRUE(cursor.reversed());
  EXPECT_TRUE(cursor.playing());
}

TEST(TimelineCursor, FollowsALogThatGrowsUntilItIsMoved) {
  TimelineCursor cursor(kStart, kEnd);
  cursor.followNow();
  EXPECT_FALSE(cursor.following()) << "this log does not grow";
  cursor.setGrowing(true);
  cursor.followNow();
  EXPECT_TRUE(cursor.playing());
  EXPECT_EQ(cursor.position(at(1s)), kEnd);
  cursor.resize(kStart, kEnd + 5s);
  EXPECT_EQ(cursor.position(at(1s)), kEnd + 5s);
  cursor.toggle(at(2s));
  EXPECT_FALSE(cursor.playing());
  cursor.resize(kStart, kEnd + 9s);
  EXPECT_EQ(cursor.position(at(6s)), kEnd + 5s);
  cursor.toggle(at(10s));
  EXPECT_EQ(cursor.position(at(11s)), kEnd + 6s);
  EXPECT_FALSE(cursor.following());
}

TEST(TimelineCursor, PlaysOnFromASeekOutOfNowAndJoinsItAgain) {
  TimelineCursor cursor(kStart, kEnd);
  cursor.setGrowing(true);
  cursor.followNow();
  cursor.seek(kStart + 1s, at(0s));
  EXPECT_EQ(cursor.position(at(2s)), kStart + 3s);
  ASSERT_TRUE(cursor.setSpeed("100", at(2s)));
  EXPECT_EQ(cursor.position(at(5s)), kEnd);
  EXPECT_TRUE(cursor.following());
  // Slow motion cannot follow.
  ASSERT_TRUE(cursor.setSpeed("0.5", at(6s)));
  EXPECT_FALSE(cursor.following());
  EXPECT_TRUE(cursor.playing());
  cursor.resize(kStart, kEnd + 10s);
  EXPECT_EQ(cursor.position(at(8s)), kEnd + 1s);
}

TEST(TimelineCursor, StaysAtTheEndOfALogThatHasStoppedGrowing) {
  TimelineCursor cursor(kStart, kEnd);
  cursor.setGrowing(true);
  cursor.followNow();
  cursor.setGrowing(false);
  EXPECT_FALSE(cursor.playing());
  EXPECT_EQ(cursor.position(at(9s)), kEnd);
}

TEST(TimelineCursor, LeavesWhatTheRecorderHasDeleted) {
  TimelineCursor cursor(kStart, kEnd);
  cursor.setGrowing(true);
  cursor.seek(kStart + 1s, at(0s));
  cursor.resize(kStart + 4s, kEnd);
  EXPECT_EQ(cursor.position(at(0s)), kStart + 4s);
}

}  // namespace
}  // namespace rocinante
