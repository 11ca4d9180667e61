#include "player/send/playback_clock.h"

#include <gtest/gtest.h>

#include <chrono>
#include <type_traits>

namespace rocinante {
namespace {

using namespace std::chrono_literals;

static_assert(!std::is_convertible_v<SteadyTime, LogTime>);
static_assert(!std::is_convertible_v<WallTime, SteadyTime>);

TEST(PlaybackClock, AnHourAtSevenTimesEndsOnTimeToTheNanosecond) {
  const auto seven = PlaybackSpeed::parse("7").value();
  const PlaybackClock clock(LogTime{}, SteadyTime{}, seven);
  EXPECT_EQ(clock.deadline(LogTime{1h}).time_since_epoch(), Nanoseconds(3'600'000'000'000 / 7));
}

TEST(PlaybackClock, CountsFromItsAnchorsAlone) {
  const auto half = PlaybackSpeed::parse("0.5").value();
  const PlaybackClock clock(LogTime{1'000'000s}, SteadyTime{77ns}, half);
  EXPECT_EQ(clock.deadline(LogTime{1'000'000s}), SteadyTime{77ns});
  EXPECT_EQ(clock.deadline(LogTime{1'000'001s}), SteadyTime{2s + 77ns});
  EXPECT_EQ(clock.deadline(LogTime{999'999s}), SteadyTime{-2s + 77ns});
}

TEST(PlaybackClock, DeadlinesNeverGoBackwards) {
  for (const char* text : {"0.01", "0.1", "1", "3", "7", "1000", "355/113"}) {
    SCOPED_TRACE(text);
    const PlaybackClock clock(LogTime{}, SteadyTime{}, PlaybackSpeed::parse(text).value());
    auto previous = clock.deadline(LogTime{});
    for (int i = 1; i < 6000; ++i) {
      const auto next = clock.deadline(LogTime{i * 1'000'000'000LL / 6000 * 1ns});
      ASSERT_GE(next, previous);
      previous = next;
    }
  }
}

}  // namespace
}  // namespace rocinante
