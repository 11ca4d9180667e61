// What is never conflated, on a link with a bandwidth: paced, in order, and counted while it waits.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/core/relay/relay_support.h"

namespace rocinante {
namespace {

using test::RelayedListeners;
using testing::HasSubstr;

constexpr std::size_t kHeads = 28;

/// A slow link has orders of its own for the values that it sends (docs/packet-format.md).
std::string itemsButOrders(const SessionState& state) {
  return test::identityLines(state, [](const std::string& line) {
    return !line.starts_with("device ") && line.find(" order ") == std::string::npos;
  });
}

RelayOutputOptions slow(double bits_per_second, std::size_t link_bytes = 0) {
  RelayOutputOptions options;
  options.bytes_per_second = bits_per_second / 8;
  options.link_bytes = link_bytes;
  return options;
}

/// On the link, with everything that it adds.
std::size_t bytesOn(const RelayedListeners::Listener& link, std::size_t link_bytes = 0) {
  std::size_t bytes = 0;
  for (const std::string& each : link.heard) bytes += each.size() + kHeads + link_bytes;
  return bytes;
}

/// What the link may have had after so long: its rate, what makes up for a late wake-up, and the
/// last datagram.
std::size_t atMost(double bits_per_second, double seconds) {
  return static_cast<std::size_t>(bits_per_second / 8 * (seconds + 0.01)) + 300;
}

TEST(PacedLink, StatesOfASignalWaitInOrderAndTheNewestIsKept) {
  RelayedListeners net;
  const auto id = net.open(slow(2'400));
  for (int i = 0; i < 200; ++i) {
    const std::string n = std::to_string(i);
    net.receive(1 + i * 0.0005, "RK1 s@r " + n + " -\nsignal arm step \"" + n + "\"\n");
  }
  EXPECT_LE(net.relay.paced(id).waiting, 64U);
  EXPECT_GT(net.relay.paced(id).dropped, 100U);
  net.passTime(60);
  std::string heard;
  for (const std::string& each : net.listeners[id].heard) heard += each;
  EXPECT_THAT(heard, HasSubstr("signal arm step \"1\""));
  EXPECT_LT(heard.find("step \"10\""), heard.find("step \"20\""));
  EXPECT_EQ(net.listeners[id].fold.state.findSignal("arm", {"", "step"})->value.text, "199");
}

TEST(PacedLink, TenThousandStatesAtOnceLeaveSixtyFourOfEachSignalAndAreCounted) {
  RelayedListeners net;
  const auto id = net.open(slow(28'800));
  std::string text;
  for (int i = 0; i < 5'000; ++i) {
    text += "signal arm step \"" + std::to_string(i) +
            "\"\nsignals - busy=" + (i % 2 == 0 ? "false" : "true") + '\n';
  }
  // As many statements as a datagram may have, so several.
  int sequence = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.rfind("signal arm", std::min(at + 20'000, text.size()));
    const std::size_t next = end <= at || text.size() - at <= 20'000 ? text.size() : end;
    net.receive(1, "RK1 s@r " + std::to_string(sequence++) + " -\n" + text.substr(at, next - at));
    at = next;
  }
  EXPECT_LE(net.relay.paced(id).waiting, 2U * PacedStatements::kMaxStates);
  EXPECT_LE(net.relay.paced(id).most, 2U * PacedStatements::kMaxStates);
  const std::uint64_t dropped = net.relay.paced(id).dropped;
  EXPECT_GT(dropped, 9'800U);
  net.passTime(20);
  std::size_t came = 0;
  for (const std::string& each : net.listeners[id].heard) {
    if (each.find(" part=") != each.npos) continue;
    for (std::size_t at = 0; (at = each.find("signal", at)) != each.npos; ++at) ++came;
  }
  EXPECT_EQ(came + dropped, 10'000U) << "each change came or is counted";
  const SessionState& heard = net.listeners[id].fold.state;
  EXPECT_EQ(heard.findSignal("arm", {"", "step"})->value.text, "4999");
  EXPECT_EQ(heard.findSignal("", {"", "busy"})->value.number, 1);
}

TEST(PacedLink, EventsWaitForTheLinkAndAllArriveInOrder) {
  RelayedListeners net;
  const auto id = net.open(slow(28'800));
  constexpr int kEvents = 2000;
  for (int i = 0; i < kEvents; ++i) {
    const std::string n = std::to_string(i);
    net.receive(1 + i * 0.0005,
                "RK1 s@r " + n + " -\njoints arm " + n + "\nevent \"number " + n + "\"\n");
  }
  EXPECT_LE(bytesOn(net.listeners[id]), atMost(28'800, 1));
  EXPECT_GT(net.relay.paced(id).waiting, 1900U);
  const auto early = net.listeners[id].heard.size();
  EXPECT_GT(net.listeners[id].fold.device("arm").joints->value[0], 1900)
      << "values take turns with events";

  net.passTime(61);
  EXPECT_LE(bytesOn(net.listeners[id]), atMost(28'800, 60));
  EXPECT_GT(net.listeners[id].heard.size(), early);
  EXPECT_EQ(net.relay.paced(id).waiting, 0U);
  EXPECT_GT(net.relay.paced(id).most, 1U);
  const std::vector<Event> events = net.listeners[id].fold.state.takeEvents();
  ASSERT_EQ(events.size(), std::size_t{kEvents});
  for (std::size_t i = 0; i < events.size(); ++i)
    EXPECT_EQ(events[i].text, "number " + std::to_string(i));
  EXPECT_EQ(itemsAndSources(net.listeners[id].fold.state), itemsAndSources(net.relay.state()));
}

TEST(PacedLink, AnEventWhoseSequenceWasUsedIsTheSourcesOwnWithoutOne) {
  RelayedListeners net;
  const auto id = net.open(slow(9'600));
  net.receive(1, "RK1 s@r 0 5\nevent \"" + std::string(120, 'a') + "\"\n");
  net.receive(1, "RK1 s@r 1 6\njoints arm 1\nevent \"late\"\n");
  net.passTime(5);
  ASSERT_GE(net.listeners[id].heard.size(), 3U);
  EXPECT_THAT(net.listeners[id].heard[2],
              HasSubstr("RK1 s@r - 6 via=site:1:2 through=site\nevent \"late\"\n"));
  const std::vector<Event> events = net.listeners[id].fold.state.takeEvents();
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(net.listeners[id].fold.device("arm").joints->value[0], 1);
}

TEST(PacedLink, TheBytesThatTheLinkAddsCount) {
  for (const std::size_t overhead : {0U, 8U, 14U}) {
    RelayedListeners net;
    const auto id = net.open(slow(28'800, overhead));
    for (int i = 0; i < 20'000; ++i) {
      net.receive(1 + i * 0.001, "RK1 s " + std::to_string(i) + " -\njoints d" +
                                     std::to_string(i % 3) + ' ' + std::to_string(i) + "\n");
    }
    const std::size_t bytes = bytesOn(net.listeners[id], overhead);
    EXPECT_LE(bytes, atMost(28'800, 20)) << overhead;
    EXPECT_GE(bytes, 28'800 / 8 * 19U) << overhead;
  }
}

TEST(PacedLink, WhatHasNoRoomToWaitIsCounted) {
  RelayedListeners net;
  const auto id = net.open(slow(1'200));
  for (int i = 0; i < 1000; ++i) {
    net.receive(1, "RK1 s " + std::to_string(i) + " -\nevent \"" + std::string(4000, 'e') + "\"\n");
  }
  const PacedCounts counts = net.relay.paced(id);
  EXPECT_GT(counts.dropped, 700U);
  EXPECT_EQ(counts.waiting, counts.most);
  EXPECT_LE(counts.waiting * 4000, PacedStatements::kMaxBytes);
  EXPECT_EQ(counts.waiting + counts.dropped + net.listeners[id].fold.state.takeEvents().size(),
            1000U);
}

TEST(PacedLink, OfChangesAboutOneThingOnlyTheNewestWaits) {
  RelayedListeners net;
  const auto id = net.open(slow(1'200));
  net.receive(1, "RK1 s 0 -\nevent \"" + std::string(200, 'e') + "\"\n");
  for (int i = 1; i < 500; ++i) {
    net.receive(1, "RK1 s " + std::to_string(i) +
                       " -\nadd tray t\nremove tray\nerase path\norder arm a" + std::to_string(i) +
                       "\n");
  }
  // A source's order goes with the values that need it, and does not wait.
  EXPECT_EQ(net.relay.paced(id).waiting, 2U);
  net.passTime(30);
  EXPECT_EQ(itemsButOrders(net.listeners[id].fold.state), itemsButOrders(net.relay.state()));
}

// Devices, drawings and orders that come and go faster than the link.
TEST(PacedLink, ChangesNeverUndoWhatIsNewer) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    RelayedListeners net;
    RelayOutputOptions options = slow(2'000 + 1'000.0 * (seed % 7));
    const auto id = net.open(options);
    for (int i = 0; i < 3000; ++i) {
      const std::string source(1, static_cast<char>('a' + random() % 2));
      const std::string device(1, static_cast<char>('p' + random() % 4));
      const std::string value = std::to_string(random() % 9);
      const std::vector<std::string> says = {
          "add " + device + " m" + value,
          "remove " + device,
          "joints " + device + ' ' + value + ' ' + value,
          "joint " + device + " j" + value + "=" + value,
          "order " + device + " j" + value + " k",
          "color " + device + " #ff000" + value,
          "line l" + value + " #ff0000 0 0 " + value,
          "erase l" + value,
          "erase *",
      };
      net.receive(1 + i * 0.002, "RK1 " + source + "@r " + std::to_string(i) + " -\n" +
                                     says[random() % says.size()] + "\n" +
                                     says[random() % says.size()] + "\n");
    }
    net.passTime(60);
    // While it restates a device, a listener has a part of it for a moment.
    for (int i = 0; i < 400 && itemsButOrders(net.listeners[id].fold.state) !=
                                   itemsButOrders(net.relay.state());
         ++i) {
      net.passTime(net.now() + 0.05);
    }
    EXPECT_EQ(itemsButOrders(net.listeners[id].fold.state), itemsButOrders(net.relay.state()))
        << seed;
    EXPECT_EQ(net.relay.paced(id).waiting, 0U);
  }
}

}  // namespace
}  // namespace rocinante
