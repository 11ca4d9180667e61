#include "recorder/contents/activity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace rocinante {
namespace {

using namespace std::chrono_literals;

constexpr LogTime kStart{Nanoseconds(1'000'000'000'000)};

std::string strip(Nanoseconds length, const std::vector<Nanoseconds>& times) {
  Activity activity(kStart, kStart + length);
  for (const Nanoseconds time : times) activity.add(kStart + time);
  return activityStrip(activity.parts());
}

std::string repeated(const char* sign, int count) {
  std::string line;
  for (int i = 0; i < count; ++i) line += sign;
  return line;
}

/// Evenly from `first` on, each a little early or late by a fixed sequence.
std::vector<Nanoseconds> steady(double hz, Nanoseconds first, Nanoseconds until,
                                double jitter = 0) {
  std::vector<Nanoseconds> times;
  std::uint32_t noise = 7;
  for (int i = 0;; ++i) {
    noise = noise * 1664525U + 1013904223U;
    const double off = jitter * (static_cast<double>(noise >> 8U) / (1U << 24U) - 0.5);
    const Nanoseconds time = first + Nanoseconds(static_cast<std::int64_t>((i + off) / hz * 1e9));
    if (time > until) return times;
    times.push_back(std::max(time, Nanoseconds(0)));
  }
}

TEST(Activity, ASteadyRateIsALevelLine) {
  for (const double hz : {30.0, 50.0, 59.94, 60.0, 100.0, 1000.0, 6000.0}) {
    for (const Nanoseconds length : {Nanoseconds(1s), Nanoseconds(3s), Nanoseconds(7777ms)}) {
      for (const Nanoseconds first : {Nanoseconds(0), Nanoseconds(3ms), Nanoseconds(16ms)}) {
        EXPECT_EQ(strip(length, steady(hz, first, length)), repeated("█", 24))
            << hz << " Hz, " << length.count() << " ns, from " << first.count();
      }
    }
  }
  EXPECT_EQ(strip(10s, steady(60, 0s, 10s, 0.3)), repeated("█", 24)) << "with jitter";
}

TEST(Activity, ARateThatHalvesIsSeen) {
  std::vector<Nanoseconds> times = steady(60, 0s, 6s);
  for (const Nanoseconds time : steady(30, 6s, 12s)) {
    if (time > 6s) times.push_back(time);
  }
  EXPECT_EQ(strip(12s, times), repeated("█", 12) + repeated("▄", 12));
}

TEST(Activity, ASilenceIsDots) {
  std::vector<Nanoseconds> times = steady(100, 0s, 8s);
  for (const Nanoseconds time : steady(100, 16s, 24s)) times.push_back(time);
  // At 8 s and at 24 s a last message is on the edge of a part.
  EXPECT_EQ(strip(24s, times), repeated("█", 8) + repeated("·", 8) + repeated("█", 8));
}

TEST(Activity, SingleMessagesStandInTheirOwnParts) {
  EXPECT_EQ(strip(24s, {5500ms}), repeated("·", 5) + "█" + repeated("·", 18));
  EXPECT_EQ(strip(24s, {500ms, 10500ms, 24s}),
            "█" + repeated("·", 9) + "█" + repeated("·", 12) + "█");
  EXPECT_EQ(strip(24s, {}), repeated("·", 24));
  // At one moment, and in a session that has no length.
  EXPECT_EQ(strip(24s, {2s, 2s, 2s}), "··█" + repeated("·", 21));
  EXPECT_EQ(strip(0s, {0s}), "█" + repeated("·", 23));
  EXPECT_EQ(strip(0s, {0s, 0s}), "█" + repeated("·", 23));
}

TEST(Activity, APartWithAMessageIsNeverADot) {
  std::vector<Nanoseconds> times = steady(6000, 0s, 1s);
  times.push_back(20s);
  EXPECT_EQ(strip(24s, times), "█" + repeated("·", 19) + "▁" + repeated("·", 3));
}

}  // namespace
}  // namespace rocinante
