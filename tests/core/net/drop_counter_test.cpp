#include <gtest/gtest.h>

#include "core/net/receive_buffer.h"

namespace rocinante {
namespace {

TEST(DropCounter, FollowsTheKernelsCount) {
  DropCounter drops;
  EXPECT_EQ(drops.total(), 0U);
  drops.update(5);
  drops.update(5);
  drops.update(9);
  EXPECT_EQ(drops.total(), 9U);
}

TEST(DropCounter, AnOlderReadingTakesNothingBack) {
  DropCounter drops;
  drops.update(100);
  drops.update(60);
  EXPECT_EQ(drops.total(), 100U);
  drops.update(101);
  EXPECT_EQ(drops.total(), 101U);
}

TEST(DropCounter, CountsOnPastThirtyTwoBits) {
  DropCounter drops;
  std::uint32_t kernel = 0;
  std::uint64_t truth = 0;
  for (int reading = 0; reading < 20; ++reading) {
    kernel += 1'500'000'000U;
    truth += 1'500'000'000U;
    drops.update(kernel);
    drops.update(kernel - 40U);
    EXPECT_EQ(drops.total(), truth);
  }
}

}  // namespace
}  // namespace rocinante
