#include "core/behaviour/time_map.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

LogTime secondsAt(double seconds) {
  return LogTime(Nanoseconds(static_cast<std::int64_t>(seconds * 1e9)));
}

TEST(TimeMap, IsLinearBetweenKnotsAndKeepsItsRateOutside) {
  TimeMap map;
  map.knots = {{secondsAt(10), secondsAt(110)}, {secondsAt(20), secondsAt(130)}};
  EXPECT_EQ(map.inRun(secondsAt(15)), secondsAt(120));
  EXPECT_EQ(map.inAccepted(secondsAt(120)), secondsAt(15));
  EXPECT_EQ(map.inRun(secondsAt(5)), secondsAt(105));
  EXPECT_EQ(map.inRun(secondsAt(25)), secondsAt(135));
  map.rate = 1.0001;
  EXPECT_EQ(map.inRun(secondsAt(30)), secondsAt(140.001));
}

TEST(ClockRate, IsTheMedianOfPairsAndNoMoreThanClocksAreOff) {
  std::vector<TimeMap::Knot> events;
  for (int i = 0; i <= 20; ++i) events.push_back({secondsAt(i * 5), secondsAt(i * 5 * 1.0002)});
  EXPECT_NEAR(clockRate(events), 1.0002, 1e-6);
  events[20].run += std::chrono::milliseconds(70);  // one event is late
  EXPECT_NEAR(clockRate(events), 1.0002, 1e-6);
  for (auto& event : events) event.run += (event.run - secondsAt(0)) / 1000;
  EXPECT_EQ(clockRate(events), 1);  // no clock is 1,000 ppm off
  EXPECT_EQ(clockRate({{secondsAt(0), secondsAt(0)}, {secondsAt(1), secondsAt(1.0002)}}),
            1);  // too short to tell
}

}  // namespace
}  // namespace rocinante
