#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "core/packet/packet_text.h"
#include "core/packet/session_state.h"

// One source that reaches a listener by two paths, one behind the other.
namespace rocinante {
namespace {

struct Arrival {
  std::size_t at;  ///< in steps of the source
  int path;
  std::size_t packet;
};

std::vector<std::string> session(std::size_t packets) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < packets; ++i) {
    all.push_back(fmt::format("RK1 arm@a {} {}\njoints arm {}\n", 1'000 + i, i, i));
  }
  return all;
}

SessionState fold(const std::vector<std::string>& packets, const std::vector<Arrival>& arrivals) {
  SessionState state;
  PacketTextDecoder decoder;
  for (const Arrival& each : arrivals) {
    const Packet* const packet = decoder.decode(bytesOf(packets[each.packet]));
    EXPECT_NE(packet, nullptr);
    // The same log time for all: only what was said is compared.
    state.apply(LogTime(std::chrono::seconds(1)), *packet);
  }
  return state;
}

TEST(TwoPaths, GiveTheStateOfOneAndNoFalseLosses) {
  std::mt19937 random(16);
  const std::vector<std::string> packets = session(400);
  for (int round = 0; round < 200; ++round) {
    // As far behind as a late packet may be; further is a restart.
    const std::size_t behind = random() % 60;
    const bool lossy = round % 2 != 0;
    std::vector<Arrival> one, both;
    std::size_t came_twice = 0, lost = 0;
    for (std::size_t i = 0; i < packets.size(); ++i) {
      one.push_back({i, 0, i});
      const bool is_edge = i == 0 || i + 1 == packets.size();
      const bool on_first = is_edge || !lossy || random() % 5 != 0;
      const bool on_second = !lossy || random() % 5 != 0;
      if (on_first) both.push_back({i, 0, i});
      if (on_second) both.push_back({i + behind, 1, i});
      came_twice += on_first && on_second ? 1 : 0;
      lost += on_first || on_second ? 0 : 1;
    }
    std::ranges::stable_sort(both, {}, &Arrival::at);
    const SessionState state = fold(packets, both);
    EXPECT_TRUE(state.sameAs(fold(packets, one)));
    const SourceCounts& counts = state.counts().at("arm");
    EXPECT_EQ(counts.gap, lost) << "behind by " << behind;
    EXPECT_EQ(counts.duplicates, came_twice);
    EXPECT_EQ(counts.restarts, 0U);
    EXPECT_EQ(counts.whole, both.size());
    EXPECT_FALSE(counts.isMixed());
  }
}

TEST(TwoPaths, TheBeginningOfASourceIsNoLossEither) {
  std::vector<std::string> packets;
  for (int i = 0; i < 100; ++i)
    packets.push_back(fmt::format("RK1 arm@a {} -\njoints arm {}\n", i, i));
  for (std::size_t behind = 0; behind < 60; ++behind) {
    std::vector<Arrival> both;
    for (std::size_t i = 0; i < packets.size(); ++i) {
      both.push_back({i, 0, i});
      both.push_back({i + behind, 1, i});
    }
    std::ranges::stable_sort(both, {}, &Arrival::at);
    const SessionState state = fold(packets, both);
    EXPECT_EQ(state.counts().at("arm").gap, 0U) << "behind by " << behind;
    // A second 0 counts as a restart, by the format.
    EXPECT_EQ(state.counts().at("arm").restarts, 1U);
    EXPECT_EQ(state.sources().at("arm").highest_sequence, 99U);
  }
}

TEST(TwoPaths, AFilteredOneBesideAWholeOneIsMixed) {
  SessionState state;
  PacketTextDecoder decoder;
  const auto hear = [&](std::string_view text) {
    state.apply(LogTime(std::chrono::seconds(1)), *decoder.decode(bytesOf(text)));
    return state.counts().at("arm").isMixed();
  };
  EXPECT_FALSE(hear("RK1 arm@a 5 - via=hub:slow:1\n"));
  EXPECT_FALSE(hear("RK1 arm@a 5 - by=hub restated part=g:1/1\n"));
  EXPECT_TRUE(hear("RK1 arm@a 4 -\n"));  // late, and heard
  EXPECT_EQ(state.counts().at("arm").filtered, 1U);
  EXPECT_EQ(state.counts().at("arm").whole, 1U);
}

}  // namespace
}  // namespace rocinante
