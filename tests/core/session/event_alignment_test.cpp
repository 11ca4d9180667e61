#include "core/session/event_alignment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rocinante {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

Event eventAt(std::int64_t ms, std::string text) {
  return {LogTime(std::chrono::milliseconds(ms)), "robot", std::move(text)};
}
LogTime at(std::int64_t ms) { return LogTime(std::chrono::milliseconds(ms)); }

TEST(AlignEvents, TimesAreStraightBetweenMatchedEvents) {
  const auto alignment =
      alignEvents({eventAt(100, "a"), eventAt(200, "b"), eventAt(400, "c")},
                  {eventAt(1100, "a"), eventAt(1300, "b"), eventAt(1400, "c")}, at(0), at(1000));
  ASSERT_THAT(alignment.matched, SizeIs(3));
  EXPECT_EQ(alignment.inB(at(100)), at(1100));
  EXPECT_EQ(alignment.inB(at(150)), at(1200));
  EXPECT_EQ(alignment.inB(at(300)), at(1350));
  EXPECT_EQ(alignment.inB(at(50)), at(1050));   // one to one before the first
  EXPECT_EQ(alignment.inB(at(500)), at(1500));  // and behind the last
}

TEST(AlignEvents, AnHourOfOnePaceKeepsEveryNanosecond) {
  constexpr std::int64_t kHourMs = 3'600'000;
  const auto alignment =
      alignEvents({eventAt(0, "a"), eventAt(kHourMs, "b")},
                  {eventAt(1000, "a"), eventAt(kHourMs + 1000, "b")}, at(0), at(1000));
  for (std::int64_t ns = 1; ns < kHourMs * 1'000'000; ns += 35'999'999'999) {
    const LogTime in_a{Nanoseconds(ns)};
    ASSERT_EQ(alignment.inB(in_a) - at(1000), in_a - at(0)) << ns;
  }
}

TEST(AlignEvents, MissingAndExtraEventsAreTold) {
  const auto alignment =
      alignEvents({eventAt(1, "a"), eventAt(2, "b"), eventAt(3, "c")},
                  {eventAt(1, "a"), eventAt(2, "x"), eventAt(3, "c")}, at(0), at(0));
  EXPECT_THAT(alignment.matched, SizeIs(2));
  ASSERT_THAT(alignment.only_a, SizeIs(1));
  EXPECT_EQ(alignment.only_a[0].text, "b");
  ASSERT_THAT(alignment.only_b, SizeIs(1));
  EXPECT_EQ(alignment.only_b[0].text, "x");
}

TEST(AlignEvents, EventsOfOneTimeAndNoneAtAllDoNoHarm) {
  const auto same_time =
      alignEvents({eventAt(5, "a"), eventAt(5, "b"), eventAt(9, "c")},
                  {eventAt(7, "a"), eventAt(8, "b"), eventAt(8, "c")}, at(0), at(0));
  EXPECT_EQ(same_time.inB(at(9)), at(8));
  EXPECT_EQ(same_time.inB(at(7)), at(8));
  const auto none = alignEvents({}, {{at(3), "", "a mark"}}, at(10), at(20));
  EXPECT_THAT(none.only_b, IsEmpty());
  EXPECT_EQ(none.inB(at(15)), at(25));
}

}  // namespace
}  // namespace rocinante
