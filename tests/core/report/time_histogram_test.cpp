#include "core/report/time_histogram.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace rocinante {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

LogTime at(std::int64_t ns) { return LogTime(Nanoseconds(ns)); }

std::uint64_t total(const TimeHistogram& histogram) {
  return std::accumulate(histogram.counts().begin(), histogram.counts().end(), std::uint64_t{0});
}

TEST(TimeHistogram, CountsByTimeFromTheFirstHit) {
  TimeHistogram histogram;
  EXPECT_THAT(histogram.counts(), IsEmpty());
  const std::int64_t width = histogram.width().count();
  histogram.hit(at(1000));
  histogram.hit(at(1000 + width - 1));
  histogram.hit(at(1000 + 2 * width), 3);
  EXPECT_EQ(histogram.start(), at(1000));
  EXPECT_THAT(histogram.counts(), ElementsAre(2, 0, 3));
}

TEST(TimeHistogram, WidensItsBinsAndLosesNoHit) {
  TimeHistogram histogram;
  const std::int64_t width = histogram.width().count();
  for (std::int64_t i = 0; i < 100000; ++i) histogram.hit(at(i * width / 3));
  EXPECT_LE(histogram.counts().size(), TimeHistogram::kMaxBins);
  EXPECT_GT(histogram.counts().size(), TimeHistogram::kMaxBins / 2);
  EXPECT_EQ(total(histogram), 100000U);
  // Even hits stay even, except in the last bin, which is not full.
  const auto [low, high] =
      std::minmax_element(histogram.counts().begin(), histogram.counts().end() - 1);
  EXPECT_LE(*high - *low, 3U);
}

TEST(TimeHistogram, BearsAnyTime) {
  TimeHistogram histogram;
  histogram.hit(at(std::numeric_limits<std::int64_t>::min()));
  histogram.hit(at(std::numeric_limits<std::int64_t>::max()));
  histogram.hit(at(0));
  EXPECT_EQ(total(histogram), 3U);
  EXPECT_LE(histogram.counts().size(), TimeHistogram::kMaxBins);
}

TEST(TimeHistogram, CountsWhatLiesBeforeTheFirstHitInItsBin) {
  TimeHistogram histogram;
  histogram.hit(at(5000));
  histogram.hit(at(10));
  EXPECT_THAT(histogram.counts(), ElementsAre(2));
}

TEST(TimeHistogram, HoldsAtTheLargestCount) {
  TimeHistogram histogram;
  const std::uint32_t most = std::numeric_limits<std::uint32_t>::max();
  histogram.hit(at(0), most);
  histogram.hit(at(0), 2);
  EXPECT_THAT(histogram.counts(), ElementsAre(most));
}

}  // namespace
}  // namespace rocinante
