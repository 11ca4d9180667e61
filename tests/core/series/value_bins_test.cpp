#include "core/series/value_bins.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace rocinante {
namespace {

LogTime nanosecond(std::int64_t nanoseconds) { return LogTime(Nanoseconds(nanoseconds)); }

TEST(ValueBins, HoldLowHighAndLast) {
  ValueBins bins(nanosecond(1000), Nanoseconds(10), 8);
  bins.add(nanosecond(1000), 2);
  bins.add(nanosecond(1003), -1);
  bins.add(nanosecond(1009), 1);
  bins.add(nanosecond(1031), 5);
  ASSERT_EQ(bins.bins().size(), 4U);
  EXPECT_EQ(bins.bins()[0].low, -1);
  EXPECT_EQ(bins.bins()[0].high, 2);
  EXPECT_EQ(bins.bins()[0].last, 1);
  EXPECT_TRUE(bins.bins()[1].holds());
  const auto columns = bins.columns(nanosecond(1000), nanosecond(1040), 4);
  EXPECT_EQ(columns[1].held, 1);
  EXPECT_FALSE(columns[1].bin.hasSample());
  EXPECT_EQ(columns[3].held, 5);
}

TEST(ValueBins, DoubleTheirWidthWhenTimeOutgrowsThem) {
  ValueBins bins(nanosecond(0), Nanoseconds(1), 4);
  for (int i = 0; i < 1000; ++i) bins.add(nanosecond(i), i);
  EXPECT_EQ(bins.width(), Nanoseconds(256));
  ASSERT_EQ(bins.bins().size(), 4U);
  EXPECT_EQ(bins.bins()[0].low, 0);
  EXPECT_EQ(bins.bins()[0].high, 255);
  EXPECT_EQ(bins.bins()[3].last, 999);
  bins.add(LogTime::max(), 7);
  EXPECT_LE(bins.bins().size(), 4U);
}

TEST(ValueBins, AnEndLeavesNothingUntilTheNextSample) {
  ValueBins bins(nanosecond(0), Nanoseconds(10), 16);
  bins.add(nanosecond(5), 1);
  bins.end(nanosecond(25));
  bins.add(nanosecond(45), 2);
  const auto columns = bins.columns(nanosecond(0), nanosecond(60), 6);
  EXPECT_EQ(columns[1].held, 1);
  EXPECT_FALSE(columns[2].held.has_value());
  EXPECT_FALSE(columns[3].held.has_value());
  EXPECT_EQ(columns[4].held, 2);
}

TEST(ValueBins, ColumnsBeforeAndBehindTheLog) {
  ValueBins bins(nanosecond(100), Nanoseconds(1), 64);
  bins.add(nanosecond(100), 3);
  const auto before = bins.columns(nanosecond(0), nanosecond(50), 5);
  for (const ValueColumn& column : before) EXPECT_FALSE(column.held.has_value());
  const auto behind = bins.columns(nanosecond(200), nanosecond(300), 5);
  for (const ValueColumn& column : behind) EXPECT_EQ(column.held, 3);
  EXPECT_TRUE(bins.columns(nanosecond(5), nanosecond(5), 3)[0].bin.holds());
  EXPECT_TRUE(bins.columns(nanosecond(0), nanosecond(9), 0).empty());
}

// Whatever the widths, the extremes of everything together are those of the samples, and the last
// column has the last value.
RC_GTEST_PROP(ValueBins, LoseNoExtreme, (std::vector<std::pair<std::uint16_t, int>> samples)) {
  RC_PRE(!samples.empty());
  std::ranges::stable_sort(samples, {}, &std::pair<std::uint16_t, int>::first);
  ValueBins bins(nanosecond(0), Nanoseconds(1), 16);
  float low = 1e30F, high = -1e30F;
  for (const auto& [time, value] : samples) {
    const auto number = static_cast<float>(value % 1000);
    bins.add(nanosecond(time), static_cast<double>(number));
    low = std::min(low, number);
    high = std::max(high, number);
  }
  ValueBin all;
  const auto columns = bins.columns(nanosecond(0), nanosecond(70'000), 7);
  for (const ValueColumn& column : columns) all.append(column.bin);
  RC_ASSERT(all.low == low);
  RC_ASSERT(all.high == high);
  RC_ASSERT(columns.back().held == static_cast<float>(samples.back().second % 1000));
}

TEST(CountBins, RatesAreMeansAroundAColumn) {
  CountBins bins(nanosecond(0), Nanoseconds(1'000'000), 4096);
  for (int i = 0; i < 1000; ++i) bins.add(nanosecond(i * 10'000'000L));  // 100 a second, for 10 s
  EXPECT_EQ(bins.total(), 1000);
  const auto rates = bins.rates(nanosecond(0), nanosecond(10'000'000'000), 100,
                                std::chrono::seconds(1), nanosecond(10'000'000'000));
  for (const float rate : rates) EXPECT_NEAR(rate, 100, 4);
  // A part of it that is shorter than the mean.
  const auto part = bins.rates(nanosecond(5'000'000'000), nanosecond(5'001'000'000), 10,
                               std::chrono::seconds(1), nanosecond(10'000'000'000));
  for (const float rate : part) EXPECT_NEAR(rate, 100, 4);
}

TEST(CountBins, KeepTheirSumWhenTheyOutgrow) {
  CountBins bins(nanosecond(0), Nanoseconds(1), 8);
  for (int i = 0; i < 5000; ++i) bins.add(nanosecond(i));
  std::int64_t sum = 0;
  for (const std::int64_t count : bins.counts()) sum += count;
  EXPECT_EQ(sum, 5000);
  EXPECT_LE(bins.counts().size(), 8U);
}

}  // namespace
}  // namespace rocinante
