#include "core/base/duration_text.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

namespace rocinante {
namespace {

using namespace std::chrono_literals;

TEST(ParseDuration, ReadsWhatPeopleWrite) {
  const std::pair<const char*, Nanoseconds> cases[] = {
      {"12.5", 12'500ms}, {"12.5s", 12'500ms},
      {"250ms", 250ms},   {"50us", 50us},
      {"10ns", 10ns},     {"1m02.5s", 62'500ms},
      {"1h30m", 90min},   {"1m2", 62s},
      {"-1s", -1s},       {"0.000000001", 1ns},
      {".5s", 500ms},     {"1.5h", 90min},
      {"0", 0ns},         {"1h2m3s4ms5us6ns", 3'723'004'005'006ns},
  };
  for (const auto& [text, expected] : cases) {
    SCOPED_TRACE(text);
    const auto duration = parseDuration(text);
    ASSERT_TRUE(duration.ok());
    EXPECT_EQ(*duration, expected);
  }
}

TEST(ParseDuration, RefusesWhatIsNoDuration) {
  for (const char* text :
       {"", "-", "s", ".", "1x", "1 s", "+1s", "1e3", "0x10", "nan", "inf", "1s1m", "1s1s", "1ms2",
        "0.0000000001", "1.5ns", "9999999999999s", "99999999999999999999999999999999999"}) {
    SCOPED_TRACE(text);
    const auto duration = parseDuration(text);
    ASSERT_FALSE(duration.ok());
    EXPECT_EQ(duration.error().kind, ErrorKind::bad_argument);
    EXPECT_EQ(duration.error().where, text);
  }
}

TEST(ParseRfc3339, ReadsZonesAndNanoseconds) {
  using std::chrono::sys_days;
  const auto day = sys_days(std::chrono::year(2026) / 2 / 3);
  const auto expected = day + 4h + 5min + 6s + 789'000'001ns;
  for (const char* text : {"2026-02-03T04:05:06.789000001Z", "2026-02-03T05:05:06.789000001+01:00",
                           "2026-02-02T23:35:06.789000001-04:30"}) {
    SCOPED_TRACE(text);
    const auto time = parseRfc3339(text);
    ASSERT_TRUE(time.ok());
    EXPECT_EQ(*time, expected);
  }
  EXPECT_EQ(parseRfc3339("1970-01-01T00:00:00Z")->time_since_epoch(), 0ns);
}

TEST(ParseRfc3339, RefusesWhatIsNoMoment) {
  for (const char* text :
       {"2026-02-30T00:00:00Z", "2026-02-03", "2026-02-03T04:05:06", "2026-02-03T24:00:00Z",
        "2026-02-03T04:05:06.Z", "2026-02-03T04:05:06.0000000001Z", "0001-01-01T00:00:00Z",
        "2026-02-03T04:05:06Zz", "2026-02-03T04:05:06+99:00"}) {
    SCOPED_TRACE(text);
    EXPECT_FALSE(parseRfc3339(text).ok());
  }
}

TEST(SecondsText, ShowsWhatIsThereAndNoMore) {
  EXPECT_EQ(secondsText(12'500ms), "12.5");
  EXPECT_EQ(secondsText(12'500ms, 3), "12.500");
  EXPECT_EQ(secondsText(0ns), "0");
  EXPECT_EQ(secondsText(0ns, 3), "0.000");
  EXPECT_EQ(secondsText(-1ns), "-0.000000001");
  EXPECT_EQ(secondsText(100s), "100");
  EXPECT_EQ(secondsText(Nanoseconds::min()), "-9223372036.854775808");
}

TEST(Rfc3339Text, HasNineDecimalsAndOneFraction) {
  const auto text = [](std::int64_t count) { return rfc3339Text(WallTime(Nanoseconds(count))); };
  EXPECT_EQ(text(1'770'091'506'500'000'000), "2026-02-03T04:05:06.500000000Z");
  EXPECT_EQ(text(0), "1970-01-01T00:00:00.000000000Z");
  EXPECT_EQ(text(-1), "1969-12-31T23:59:59.999999999Z");
  EXPECT_EQ(text(std::numeric_limits<std::int64_t>::max()), "2262-04-11T23:47:16.854775807Z");
  EXPECT_EQ(text(std::numeric_limits<std::int64_t>::min()), "1677-09-21T00:12:43.145224192Z");
}

TEST(Rfc3339Text, ReadsBackAsTheSameMoment) {
  for (const std::int64_t count : {0LL, 1LL, -1LL, 1'770'091'506'789'000'001LL}) {
    const WallTime time{Nanoseconds(count)};
    EXPECT_EQ(parseRfc3339(rfc3339Text(time)).value(), time) << rfc3339Text(time);
  }
}

}  // namespace
}  // namespace rocinante
