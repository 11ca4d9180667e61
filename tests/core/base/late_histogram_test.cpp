#include "core/base/late_histogram.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

using namespace std::chrono_literals;

TEST(LateHistogram, ItsBinsAreAPersonsAndHoldEverything) {
  LateHistogram late;
  for (const Nanoseconds each : {-5ns, 0ns, 1ns, 2'000ns, 2'001ns, 5'000ns, 10'000ns, 20'000ns}) {
    late.add(each);
  }
  late.add(1h);
  std::string text;
  for (const auto& [up_to_us, count] : late.bins()) {
    text += std::to_string(up_to_us) + ":" + std::to_string(count) + " ";
  }
  EXPECT_EQ(text, "1:3 2:1 5:2 10:1 20:1 5000000000:1 ");
}

TEST(LateHistogram, IsExactToAMicrosecondRoundedUp) {
  LateHistogram late;
  for (int us = 1; us <= 1000; ++us) late.add(us * 1us);
  EXPECT_EQ(late.percentile(0.5), 500U);
  EXPECT_EQ(late.percentile(0.9), 900U);
  EXPECT_EQ(late.percentile(0.99), 990U);
  EXPECT_EQ(late.percentile(0.999), 999U);
  EXPECT_EQ(late.percentile(1), 1000U);
  EXPECT_EQ(late.percentile(0), 1U);
  EXPECT_EQ(late.max(), 1000U);
  EXPECT_EQ(late.count(), 1000U);
}

TEST(LateHistogram, NeverFlatters) {
  LateHistogram late;
  late.add(1ns);
  EXPECT_EQ(late.percentile(0.5), 1U);
  late.add(1001ns);
  EXPECT_EQ(late.max(), 2U);
}

TEST(LateHistogram, EarlyIsNotLate) {
  LateHistogram late;
  late.add(-5ms);
  late.add(0ns);
  EXPECT_EQ(late.percentile(1), 0U);
}

TEST(LateHistogram, IsExactUpToFourSecondsAndWithinOneInThirtyTwoBeyond) {
  LateHistogram late;
  late.add(4'194'303us);
  EXPECT_EQ(late.percentile(0.5), 4'194'303U);
  for (const Nanoseconds value :
       {Nanoseconds(4'194'304us), Nanoseconds(5s), Nanoseconds(1h), Nanoseconds(24h * 365 * 200)}) {
    LateHistogram one;
    one.add(value);
    one.add(Nanoseconds::max());
    const double exact = static_cast<double>(value.count()) / 1e3;
    EXPECT_GE(static_cast<double>(one.percentile(0.5)), exact);
    EXPECT_LE(static_cast<double>(one.percentile(0.5)), exact * (1 + 1.0 / 32) + 1);
  }
}

TEST(LateHistogram, OfNothingIsZero) {
  EXPECT_EQ(LateHistogram().percentile(0.99), 0U);
  EXPECT_EQ(LateHistogram().max(), 0U);
}

TEST(DriftMeter, ComparesTheLastHundredWithTheFirst) {
  DriftMeter drift;
  for (int i = 0; i < 100'000; ++i) drift.add(i * 1us);
  EXPECT_EQ(drift.drift(), 99'900us);
}

TEST(DriftMeter, OneBadDatagramIsNoDrift) {
  DriftMeter drift;
  for (int i = 0; i < 1000; ++i) drift.add(i == 990 ? 5s : 7us);
  EXPECT_EQ(drift.drift(), 0us);
}

TEST(DriftMeter, OfFewComparesThemWithThemselves) {
  DriftMeter drift;
  EXPECT_EQ(drift.drift(), 0ns);
  drift.add(3ms);
  drift.add(9ms);
  EXPECT_EQ(drift.drift(), 0ns);
}

}  // namespace
}  // namespace rocinante
