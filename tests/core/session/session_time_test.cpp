#include "core/session/session_time.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

constexpr std::int64_t kOrigin = 1'770'091'506'000'000'000;  // 2026-02-03T04:05:06Z
constexpr std::int64_t kEnd = kOrigin + 20'000'000'000;

Result<LogTime> parse(std::string_view text) {
  return parseSessionTime(text, LogTime(Nanoseconds(kOrigin)), LogTime(Nanoseconds(kEnd)));
}

TEST(SessionTime, ReadsTheFormsThatPeopleType) {
  const std::pair<const char*, std::int64_t> cases[] = {
      {"0", kOrigin},
      {"12.5", kOrigin + 12'500'000'000},
      {"12.5s", kOrigin + 12'500'000'000},
      {"1m02.5s", kOrigin + 62'500'000'000},
      {"250ms", kOrigin + 250'000'000},
      {"0.000000001", kOrigin + 1},
      {"-1s", kEnd - 1'000'000'000},
      {"-0s", kEnd},
      {"-250ms", kEnd - 250'000'000},
      {"2026-02-03T04:05:06Z", kOrigin},
      {"2026-02-03T05:05:06.789000001+01:00", kOrigin + 789'000'001},
  };
  for (const auto& [text, expected] : cases) {
    SCOPED_TRACE(text);
    const Result<LogTime> time = parse(text);
    ASSERT_TRUE(time.ok()) << time.error().text();
    EXPECT_EQ(time->time_since_epoch().count(), expected);
  }
}

TEST(SessionTime, RefusesWhatIsNoTime) {
  for (const char* text : {"", "x", "12.5q", "1.0000000001", "--1s", "2026-13-03T04:05:06Z",
                           "2026-02-03", "9223372036s", "1e3"}) {
    SCOPED_TRACE(text);
    const Result<LogTime> time = parse(text);
    ASSERT_FALSE(time.ok());
    EXPECT_EQ(time.error().kind, ErrorKind::bad_argument);
  }
}

}  // namespace
}  // namespace rocinante
