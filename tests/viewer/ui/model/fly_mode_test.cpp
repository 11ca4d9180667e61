#include "viewer/ui/model/fly_mode.h"

#include <gtest/gtest.h>

#include <limits>

namespace rocinante {
namespace {

using namespace std::chrono_literals;

constexpr SteadyTime kTakeOff{1h};

FlyKeys forward() {
  FlyKeys keys;
  keys.forward = true;
  return keys;
}

TEST(FlyMode, IsActiveFromTheFirstKeyUntilItsEnd) {
  FlyMode fly;
  EXPECT_EQ(fly.step({}, kTakeOff), Vec3(0, 0, 0));
  FlyKeys shift_alone;
  shift_alone.faster = true;
  fly.step(shift_alone, kTakeOff);
  EXPECT_FALSE(fly.active());
  fly.step(forward(), kTakeOff);
  EXPECT_TRUE(fly.active());
  EXPECT_TRUE(fly.moving());
  fly.step({}, kTakeOff + 10ms);
  EXPECT_TRUE(fly.active());
  EXPECT_FALSE(fly.moving());
  fly.end();
  EXPECT_FALSE(fly.active());
}

TEST(FlyMode, GetsThroughTheSceneInItsTime) {
  FlyMode fly;
  fly.setSceneSize(12);
  EXPECT_DOUBLE_EQ(fly.speed(), 2);
  Vec3 way = fly.step(forward(), kTakeOff);
  EXPECT_NEAR(way.y, 2.0 / 60, 1e-8);
  way = {0, 0, 0};
  for (int i = 1; i <= 100; ++i) way += fly.step(forward(), kTakeOff + i * 20ms);
  EXPECT_NEAR(way.y, 4, 1e-9);
  EXPECT_EQ(way.x, 0);
  EXPECT_EQ(way.z, 0);
}

TEST(FlyMode, TheSameTimesFlyTheSameWayWhateverIsBetween) {
  FlyMode once, again;
  for (int i = 0; i < 50; ++i) {
    FlyKeys keys = forward();
    keys.left = i % 3 == 0;
    keys.faster = i > 30;
    const SteadyTime at = kTakeOff + Nanoseconds(i * i * 1'234'567);
    EXPECT_EQ(once.step(keys, at), again.step(keys, at + 2h));
  }
}

TEST(FlyMode, ASlowFrameDoesNotFlyAway) {
  FlyMode fly;
  fly.setSceneSize(6);
  fly.step(forward(), kTakeOff);
  EXPECT_NEAR(fly.step(forward(), kTakeOff + 10s).y, 0.1, 1e-9);
  // Nor backwards, should a time be earlier.
  EXPECT_EQ(fly.step(forward(), kTakeOff).y, 0);
}

TEST(FlyMode, SlantingIsNoFasterAndOppositeKeysCancel) {
  FlyMode fly;
  fly.setSceneSize(6);
  FlyKeys keys = forward();
  keys.right = keys.up = true;
  fly.step(keys, kTakeOff);
  const Vec3 way = fly.step(keys, kTakeOff + 100ms);
  EXPECT_NEAR(lengthOf(way), 0.1, 1e-12);
  EXPECT_GT(way.x, 0);
  EXPECT_GT(way.z, 0);
  keys = forward();
  keys.back = true;
  EXPECT_EQ(fly.step(keys, kTakeOff + 200ms), Vec3(0, 0, 0));
  keys = forward();
  keys.faster = true;
  EXPECT_NEAR(fly.step(keys, kTakeOff + 300ms).y, 0.4, 1e-12);
}

TEST(FlyMode, TheWheelChangesTheSpeedAndBack) {
  FlyMode fly;
  fly.setSceneSize(6);
  fly.changeSpeed(2);
  EXPECT_DOUBLE_EQ(fly.speed(), 1.25 * 1.25);
  fly.changeSpeed(-2);
  EXPECT_DOUBLE_EQ(fly.speed(), 1);
  for (int i = 0; i < 100; ++i) fly.changeSpeed(50);
  EXPECT_DOUBLE_EQ(fly.speed(), 1000);
  fly.changeSpeed(std::numeric_limits<double>::quiet_NaN());
  EXPECT_DOUBLE_EQ(fly.speed(), 1000);
}

TEST(FlyMode, WhatIsNoSizeIsAMetre) {
  FlyMode fly;
  for (const double size : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    fly.setSceneSize(size);
    EXPECT_DOUBLE_EQ(fly.speed(), 1.0 / 6);
  }
}

}  // namespace
}  // namespace rocinante
