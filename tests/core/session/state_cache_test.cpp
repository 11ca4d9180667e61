#include "core/session/state_cache.h"

#include <gtest/gtest.h>

#include "tests/core/session/session_support.h"

namespace rocinante::test {
namespace {

constexpr LogPosition kStart{LogTime::min(), 0};

LogPosition placeAt(std::int64_t time_ns) { return {at(time_ns), 0}; }

TEST(StateCache, GivesTheLastOneNotBehindAPlace) {
  StateCache cache;
  EXPECT_EQ(cache.nearest(placeAt(5)), nullptr);
  cache.keep(placeAt(10), {}, kStart, 1000);
  cache.keep(placeAt(20), {}, kStart, 2000);
  EXPECT_EQ(cache.nearest(placeAt(9)), nullptr);
  EXPECT_EQ(cache.nearest(placeAt(10))->first, placeAt(10));
  EXPECT_EQ(cache.nearest(placeAt(19))->first, placeAt(10));
  EXPECT_EQ(cache.nearest(placeAt(99))->first, placeAt(20));
}

TEST(StateCache, StaysBoundedAndSpreadOverTheWay) {
  StateCache cache;
  constexpr std::int64_t kCount = 5000;
  for (std::int64_t i = 1; i <= kCount; ++i) {
    cache.keep(placeAt(i), {}, kStart, static_cast<std::uint64_t>(i) * 1000);
  }
  EXPECT_LE(cache.count(), StateCache::kMaxStates);
  // Along a path taken once, no long stretch is without a state.
  for (std::int64_t i = 200; i <= kCount; i += 100) {
    ASSERT_NE(cache.nearest(placeAt(i)), nullptr);
    EXPECT_GE(cache.nearest(placeAt(i))->first, placeAt(i - 100)) << i;
  }
}

TEST(StateCache, LargeStatesAreBoundedByTheirMemory) {
  HandFold fold;
  std::string text = "RK1 s - -\npoints p #ffffff";
  for (int i = 0; i < 30'000; ++i) text += " 1";
  fold.fold(at(1), bytesOf(text));
  EXPECT_GT(StateCache::interval(fold.state), 4000U);
  StateCache cache;
  for (std::int64_t i = 1; i <= 400; ++i) {
    cache.keep(placeAt(i), fold.state, kStart, static_cast<std::uint64_t>(i));
  }
  EXPECT_LE(cache.bytes(), StateCache::kMaxBytes);
  EXPECT_LT(cache.count(), 300U);
  EXPECT_GT(cache.count(), 100U);
}

}  // namespace
}  // namespace rocinante::test
