#include "core/base/min_change.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

TEST(MinChange, ReadsItsListAndTheGreatestPatternCounts) {
  MinChange least;
  EXPECT_FALSE(least.any());
  ASSERT_TRUE(least.addAll("joint=0.5,signal=0.1,signal arm *=2,signal arm a[=b]=1").ok());
  EXPECT_TRUE(least.any());
  EXPECT_EQ(least.joint, 0.5);
  EXPECT_EQ(least.ofSignal("leg x"), 0.1);
  EXPECT_EQ(least.ofSignal("arm x"), 2);
  EXPECT_EQ(least.signals.back().pattern, "arm a[=b]");
}

TEST(MinChange, HoldsWhatEitherHolds) {
  MinChange one, other;
  ASSERT_TRUE(one.addAll("joint=1,turn=2,signal=3").ok());
  ASSERT_TRUE(other.addAll("joint=2,turn=1,position=4,signal arm *=5").ok());
  one.join(other);
  EXPECT_EQ(one.joint, 2);
  EXPECT_EQ(one.turn, 2);
  EXPECT_EQ(one.position, 4);
  EXPECT_EQ(one.ofSignal("arm x"), 5);
  EXPECT_EQ(one.ofSignal("leg x"), 3);
}

TEST(MinChange, RefusesWhatHoldsNothing) {
  for (const char* text : {"", "joint", "joint=", "joint=0", "turn=-1", "signal=nan", "signal=inf",
                           "signal =1", "speed=1", "joint=1,", "joint=1,,turn=1", "joint=1k"}) {
    EXPECT_FALSE(MinChange().addAll(text).ok()) << text;
  }
}

}  // namespace
}  // namespace rocinante
