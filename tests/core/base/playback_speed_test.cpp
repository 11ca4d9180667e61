#include "core/base/playback_speed.h"

#include <gtest/gtest.h>

#include <chrono>

namespace rocinante {
namespace {

using namespace std::chrono_literals;

TEST(PlaybackSpeed, ReadsDecimalsAndRatios) {
  EXPECT_EQ(PlaybackSpeed::parse("0.25").value().realDuration(1s), 4s);
  EXPECT_EQ(PlaybackSpeed::parse("3/2").value().realDuration(3s), 2s);
  EXPECT_EQ(PlaybackSpeed::parse("10").value().realDuration(1h), 6min);
  EXPECT_EQ(PlaybackSpeed::parse(".5").value().realDuration(1s), 2s);
  EXPECT_EQ(PlaybackSpeed::parse("2/4").value(), PlaybackSpeed::parse("0.5").value());
  EXPECT_EQ(PlaybackSpeed().realDuration(7ns), 7ns);
}

TEST(PlaybackSpeed, ReachesFromAHundredthToAThousand) {
  EXPECT_EQ(PlaybackSpeed::parse("0.01").value().realDuration(1s), 100s);
  EXPECT_EQ(PlaybackSpeed::parse("1000").value().realDuration(1s), 1ms);
  EXPECT_FALSE(PlaybackSpeed::parse("0.009").ok());
  EXPECT_FALSE(PlaybackSpeed::parse("1000.1").ok());
  EXPECT_FALSE(PlaybackSpeed::parse("1/101").ok());
}

TEST(PlaybackSpeed, RefusesWhatIsNotASpeed) {
  for (const char* text :
       {"",   "0",  "-1", "1/0",   "0/1", "fast", "1.2.3", "1e9",  "99999999999", ".",
        "2.", "1/", "/1", "1/2/3", "+1",  " 1",   "1 ",    "1.-5", "0x1",         "nan"}) {
    SCOPED_TRACE(text);
    const auto speed = PlaybackSpeed::parse(text);
    ASSERT_FALSE(speed.ok());
    EXPECT_EQ(speed.error().kind, ErrorKind::bad_argument);
    EXPECT_EQ(speed.error().where, text);
  }
}

TEST(PlaybackSpeed, SaysItselfSoThatItReadsBack) {
  for (const char* text : {"1", "0.01", "0.1", "0.25", "2", "7", "10", "1000", "1/3", "3.5",
                           "355/113", "0.12345678", "12.345678", "999.9"}) {
    SCOPED_TRACE(text);
    const auto speed = PlaybackSpeed::parse(text).value();
    EXPECT_EQ(PlaybackSpeed::parse(speed.text()).value(), speed);
    EXPECT_EQ(speed.text(), text);
  }
  EXPECT_EQ(PlaybackSpeed::parse("3/2").value().text(), "1.5");
  EXPECT_EQ(PlaybackSpeed::parse("2.500").value().text(), "2.5");
}

TEST(PlaybackSpeed, LogDurationUndoesRealDurationToTheRounding) {
  for (const char* text : {"0.01", "0.1", "1/3", "1", "7", "1000"}) {
    SCOPED_TRACE(text);
    const auto speed = PlaybackSpeed::parse(text).value();
    const Nanoseconds back = speed.logDuration(speed.realDuration(1h));
    EXPECT_LE(back, 1h);
    EXPECT_GT(back, 1h - 1000ns);
  }
}

TEST(PlaybackSpeed, CenturiesSaturateInsteadOfWrapping) {
  const auto slow = PlaybackSpeed::parse("0.01").value();
  EXPECT_EQ(slow.realDuration(Nanoseconds::max()), Nanoseconds::max());
  EXPECT_LT(slow.realDuration(-Nanoseconds::max()), 0ns);
  const auto fine = PlaybackSpeed::parse("0.99999999").value();
  EXPECT_EQ(fine.realDuration(999'999'990'000'000'000ns), 1'000'000'000'000'000'000ns);
}

}  // namespace
}  // namespace rocinante
