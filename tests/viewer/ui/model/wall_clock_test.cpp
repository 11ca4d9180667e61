#include "viewer/ui/model/wall_clock.h"

#include <gtest/gtest.h>

#include "core/base/duration_text.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

LogTime at(const char* text) { return LogTime(parseRfc3339(text).value().time_since_epoch()); }

TEST(WallClock, IsOfSessionsThatWereNotSimulated) {
  EXPECT_TRUE(hasWallClock(at("2026-11-21T05:12:07.050377919Z")));
  EXPECT_TRUE(hasWallClock(at("2000-01-01T00:00:00Z")));
  EXPECT_FALSE(hasWallClock(at("1999-12-31T23:59:59Z")));
  EXPECT_FALSE(hasWallClock(LogTime{}));
  EXPECT_FALSE(hasWallClock(LogTime{-5s}));
}

TEST(WallClock, IsTheTimeOfDayInUtc) {
  EXPECT_EQ(clockText(at("2026-11-21T05:12:07.050977919Z")), "05:12:07.050");
  EXPECT_EQ(clockText(at("2026-11-21T01:00:00+02:00")), "23:00:00.000");
  EXPECT_EQ(calendarText(at("2026-11-21T01:00:00+02:00")), "2026-11-20 23:00:00.000 UTC");
}

TEST(WallClock, LabelsAreAsExactAsTheStep) {
  const LogTime moment = at("2026-11-21T05:12:07.250000001Z");
  EXPECT_EQ(clockLabel(moment, 48h), "11-21");
  EXPECT_EQ(clockLabel(moment, 1h), "05:12");
  EXPECT_EQ(clockLabel(moment, 1min), "05:12");
  EXPECT_EQ(clockLabel(moment, 30s), "05:12:07");
  EXPECT_EQ(clockLabel(moment, 500ms), "12:07.2");
  EXPECT_EQ(clockLabel(moment, 50ms), "12:07.25");
  EXPECT_EQ(clockLabel(moment, 1ns), "12:07.250000001");
}

}  // namespace
}  // namespace rocinante
