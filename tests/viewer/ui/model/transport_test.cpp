#include "viewer/ui/model/transport.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

using namespace std::chrono_literals;

constexpr LogTime kStart{1000s};
constexpr LogTime kEnd{1020s};

SteadyTime at(Nanoseconds since) { return SteadyTime(since); }

TEST(Transport, StandsStillUntilItPlays) {
  Transport transport(kStart, kEnd);
  EXPECT_EQ(transport.position(at(5s)), kStart);
  transport.play(at(5s));
  EXPECT_EQ(transport.position(at(7s)), kStart + 2s);
  transport.pause(at(8s));
  EXPECT_EQ(transport.position(at(100s)), kStart + 3s);
}

TEST(Transport, StopsAtTheEndAndBeginsAnewFromThere) {
  Transport transport(kStart, kEnd);
  transport.play(at(0s));
  EXPECT_EQ(transport.position(at(21s)), kEnd);
  EXPECT_FALSE(transport.playing());
  transport.play(at(30s));
  EXPECT_EQ(transport.position(at(31s)), kStart + 1s);
}

TEST(Transport, LoopsWithoutLosingTime) {
  Transport transport(kStart, kEnd);
  transport.setLooping(true);
  transport.play(at(0s));
  EXPECT_EQ(transport.position(at(23s)), kStart + 3s);
  EXPECT_TRUE(transport.playing());
  EXPECT_EQ(transport.position(at(24s)), kStart + 4s);
}

TEST(Transport, ChangesSpeedWithoutAJump) {
  Transport transport(kStart, kEnd);
  transport.play(at(0s));
  EXPECT_TRUE(transport.setSpeed("2", at(3s)));
  EXPECT_EQ(transport.position(at(3s)), kStart + 3s);
  EXPECT_EQ(transport.position(at(4s)), kStart + 5s);
  EXPECT_FALSE(transport.setSpeed("fast", at(4s)));
  EXPECT_EQ(transport.speedText(), "2");
}

TEST(Transport, AThirdOfASecondAtAThirdOfTheSpeedIsExact) {
  Transport transport(kStart, kStart + 2h);
  ASSERT_TRUE(transport.setSpeed("1/3", at(0s)));
  transport.play(at(0s));
  EXPECT_EQ(transport.position(at(1h)), kStart + 20min);
}

TEST(Transport, SeeksWithinTheLogAndGoesOn) {
  Transport transport(kStart, kEnd);
  transport.play(at(0s));
  transport.seek(kStart + 10s, at(1s));
  EXPECT_EQ(transport.position(at(2s)), kStart + 11s);
  transport.seek(kStart - 5s, at(2s));
  EXPECT_EQ(transport.position(at(2s)), kStart);
  transport.step(-1s, at(3s));
  EXPECT_EQ(transport.position(at(9s)), kStart);
  transport.step(90s, at(9s));
  EXPECT_EQ(transport.position(at(9s)), kEnd);
}

TEST(Transport, ALogOfOneMomentNeitherMovesNorDividesByZero) {
  Transport transport(kStart, kStart);
  transport.setLooping(true);
  transport.play(at(0s));
  EXPECT_EQ(transport.position(at(1s)), kStart);
}

}  // namespace
}  // namespace rocinante
