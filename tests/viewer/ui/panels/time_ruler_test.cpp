#include <gtest/gtest.h>

#include <chrono>
#include <limits>

#include "viewer/ui/panels/time_axis.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

TEST(TimeRuler, StepsAreRoundAndLabelsDoNotTouch) {
  EXPECT_EQ(rulerStep(21s, 900, 64), 2s);
  EXPECT_EQ(rulerStep(100s, 900, 64), 10s);
  EXPECT_EQ(rulerStep(600s, 900, 64), 60s);
  EXPECT_EQ(rulerStep(50ms, 900, 64), 5ms);
  EXPECT_EQ(rulerStep(8h, 900, 64), 1h);
  for (std::int64_t span = 1; span < std::numeric_limits<std::int64_t>::max() / 100; span *= 3) {
    for (const double width : {40.0, 900.0, 4000.0}) {
      const Nanoseconds step = rulerStep(Nanoseconds(span), width, 64);
      ASSERT_GT(step.count(), 0) << span;
      ASSERT_GE(static_cast<double>(step.count()) * width, static_cast<double>(span) * 63.9)
          << span << " on " << width;
    }
  }
}

TEST(TimeRuler, LabelsHaveTheDecimalsOfTheStep) {
  EXPECT_EQ(rulerLabel(12s, 2s), "12");
  EXPECT_EQ(rulerLabel(12s, 500ms), "12.0");
  EXPECT_EQ(rulerLabel(65s + 250ms, 50ms), "1:05.25");
  EXPECT_EQ(rulerLabel(2h, 1h), "2:00:00");
  EXPECT_EQ(rulerLabel(-500ms, 500ms), "-0.5");
  EXPECT_EQ(rulerLabel(0s, 1s), "0");
  EXPECT_EQ(rulerLabel(5ns, 1ns), "0.000000005");
}

}  // namespace
}  // namespace rocinante
