#include "core/relay/relay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/relay/relay_support.h"

namespace rocinante {
namespace {

using test::itemsAndSources;
using test::RelayedListeners;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(Relay, AWholeOutputIsByteForByteWhatTheFoldApplies) {
  RelayedListeners net;
  const auto id = net.open();
  net.receive(1, "RK1 arm@a 5 -  shiny\r\njoints  arm 1.50 2\n# odd\n");
  net.receive(1, "RK1 arm@a 4 -\njoints arm 9 9\n");
  net.receive(1, "RK1 arm@a 5 -\njoints arm 9 9\n");
  net.receive(1, "RK1 arm@a 6 - restated part=x:1/1\njoints arm 3 4\n");
  EXPECT_THAT(net.listeners[id].heard,
              ElementsAre("RK1 arm@a 5 -  shiny\r\njoints  arm 1.50 2\n# odd\n",
                          "RK1 arm@a 6 - restated part=x:1/1\njoints arm 3 4\n"));
  EXPECT_EQ(net.relay.counts().late, 2U);
  EXPECT_EQ(net.relay.counts().applied, 2U);
}

TEST(Relay, OnlyPacketTextPasses) {
  RelayedListeners net;
  const auto id = net.open();
  for (const char* text : {"", "hello", "RKS1 leave id=0123456789abcdef\n", "RK1 arm x y\n"}) {
    net.receive(1, text);
  }
  EXPECT_TRUE(net.listeners[id].heard.empty());
  EXPECT_EQ(net.relay.counts().other, 4U);
}

TEST(Relay, WhatNewestWinsCannotJudgeSaysThroughWhomItWent) {
  RelayedListeners net;
  const auto id = net.open();
  net.receive(1, "RK1 me - -\njoints arm 1\n");
  net.receive(1, "RK1 you 3 - by=other through=other,b\r\njoints arm 1\n");
  net.receive(1, "RK1 you 4 - reset\n");
  EXPECT_THAT(net.listeners[id].heard,
              ElementsAre("RK1 me - - through=site\njoints arm 1\n",
                          "RK1 you 3 - by=other through=other,b,site\r\njoints arm 1\n",
                          "RK1 you 4 - reset through=site\n"));
}

TEST(Relay, DropsWhatHasPassedItOrMoreThanEightRelays) {
  RelayedListeners net;
  const auto id = net.open();
  for (const char* header : {"me - - through=a,site,b", "me 1 - by=site", "me 2 - via=site:3:7",
                             "me - - through=a,b,c,d,e,f,g,h,i"}) {
    net.receive(1, std::string("RK1 ") + header + "\njoints arm 1\n");
  }
  EXPECT_TRUE(net.listeners[id].heard.empty());
  EXPECT_EQ(net.relay.counts().looped, 4U);
  net.receive(1, "RK1 me - - through=a,b,c,d,e,f,g,h\njoints arm 1\n");
  EXPECT_EQ(net.listeners[id].heard.size(), 1U);
}

// Two relays that listen to each other's whole and filtered outputs fall silent when the source is.
TEST(Relay, ALoopOfTwoRelaysEnds) {
  for (const bool is_filtered : {false, true}) {
    SCOPED_TRACE(is_filtered);
    RelayOutputOptions options;
    if (is_filtered) options.filters.push_back({{"*"}, {}, ~0U});
    RelayedListeners a("a"), b("b");
    const auto to_b = a.open(options), to_a = b.open(options);
    std::size_t from_a = 0, from_b = 0;
    const auto exchange = [&](double now) {
      for (int turn = 0; turn < 50; ++turn) {
        const std::size_t before = from_a + from_b;
        for (; from_a < a.listeners[to_b].heard.size(); ++from_a) {
          b.receive(now, a.listeners[to_b].heard[from_a]);
        }
        for (; from_b < b.listeners[to_a].heard.size(); ++from_b) {
          a.receive(now, b.listeners[to_a].heard[from_b]);
        }
        if (from_a + from_b == before) return;
      }
      FAIL() << "it goes round";
    };
    a.receive(1, "RK1 me - -\njoints arm 1\nevent \"x\"\n");
    a.receive(1, "RK1 you 1 -\njoints leg 1\n");
    exchange(1);
    for (int tenth = 0; tenth < 100; ++tenth) {
      a.passTime(1 + tenth * 0.1);
      b.passTime(1 + tenth * 0.1);
      exchange(1 + tenth * 0.1);
    }
    EXPECT_LT(a.listeners[to_b].heard.size() + b.listeners[to_a].heard.size(), 60U);
    EXPECT_EQ(itemsAndSources(a.relay.state()), itemsAndSources(b.relay.state()));
  }
}

TEST(Relay, GreetsALateListenerWithTheWholeState) {
  RelayedListeners net;
  for (int i = 0; i < 1000; ++i) {
    net.receive(1, "RK1 s" + std::to_string(i % 7) + "@r " + std::to_string(i) + " 17.5\nadd d" +
                       std::to_string(i) + " m\njoints d" + std::to_string(i) +
                       " 0.1 0.2 0.3 0.4 0.5 0.6\npose d" + std::to_string(i) + " 1 2 3 0 0 0 1\n");
  }
  const auto id = net.open();
  net.relay.greet(id);
  net.passTime(1.1);
  const auto& listener = net.listeners[id];
  EXPECT_EQ(listener.fold.state.identityText().size(), net.relay.state().identityText().size());
  EXPECT_EQ(itemsAndSources(listener.fold.state), itemsAndSources(net.relay.state()));
  EXPECT_THAT(listener.heard.front(), HasSubstr(" by=site through=site\n"));
  EXPECT_THAT(listener.heard.front(), Not(HasSubstr("via=")));
  for (const std::string& text : listener.heard) EXPECT_LE(text.size(), 1200U);
}

// 64 datagrams in 10 ms, while the sources go on: each part has the values of its moment.
TEST(Relay, AGreetingIsPacedAndNeverOlderThanWhatPasses) {
  RelayedListeners net;
  int sequence = 0;
  const auto move = [&](double seconds, int device) {
    const std::string number = std::to_string(sequence++);
    net.receive(seconds, "RK1 s@r " + number + " -\njoints d" + std::to_string(device) + ' ' +
                             number + std::string(60, '5') + "\n");
  };
  for (int i = 0; i < 4000; ++i) move(1, i);
  const auto id = net.open();
  net.relay.greet(id);
  net.passTime(1.001);
  EXPECT_EQ(net.listeners[id].heard.size(), 64U);
  for (int i = 0; i < 2000; ++i) move(1.001 + i * 1e-4, (i * 7) % 4000);
  net.passTime(1.5);
  EXPECT_EQ(itemsAndSources(net.listeners[id].fold.state), itemsAndSources(net.relay.state()));
  EXPECT_EQ(net.listeners[id].fold.counts("s").late, 0U);
}

TEST(Relay, AGreetingThatTakesTooLongHasNoParts) {
  RelayedListeners net;
  const std::string names(200, 'n');
  for (int i = 0; i < 10'000; ++i) {
    net.receive(1, "RK1 s " + std::to_string(i) + " -\nadd " + names + std::to_string(i) + " m" +
                       names + "\nshow " + names + std::to_string(i) + "\n");
  }
  const auto id = net.open();
  net.relay.greet(id);
  net.passTime(3);
  const auto& heard = net.listeners[id].heard;
  EXPECT_GT(heard.size(), 3200U);
  for (const std::string& text : heard) ASSERT_THAT(text, Not(HasSubstr("part=")));
  EXPECT_EQ(itemsAndSources(net.listeners[id].fold.state), itemsAndSources(net.relay.state()));
}

TEST(Relay, FourAreGreetedAtATimeAndTheOthersLater) {
  RelayedListeners net;
  for (int i = 0; i < 300; ++i) {
    net.receive(1, "RK1 s " + std::to_string(i) + " -\nadd d" + std::to_string(i) + " m" +
                       std::string(200, 'n') + "\n");
  }
  for (int i = 0; i < 20; ++i) net.relay.greet(net.open());
  net.passTime(1.0001);
  std::size_t heard = 0;
  for (const auto& each : net.listeners) heard += each.second.heard.size();
  EXPECT_LE(heard, 4 * 64U);
  net.passTime(2);
  for (const auto& each : net.listeners) {
    EXPECT_EQ(itemsAndSources(each.second.fold.state), itemsAndSources(net.relay.state()));
  }
}

TEST(Relay, PlayersThatSeekAndLoopAreFollowed) {
  RelayedListeners net;
  RelayOutputOptions slow;
  slow.pacing.interval = std::chrono::milliseconds(100);
  const auto whole = net.open();
  const auto filtered = net.open(slow);
  for (int turn = 0; turn < 3; ++turn) {
    const double start = 2 + turn * 5;
    net.receive(start, "RK1 arm@a 5 105 restated part=p" + std::to_string(turn) +
                           ":1/1 by=player reset\njoints arm 5\n");
    for (int i = 6; i < 90; ++i) {
      net.receive(start + i * 0.01, "RK1 arm@a " + std::to_string(i) + " -\njoints arm " +
                                        std::to_string(i) + "\nshow d" + std::to_string(i) + "\n");
    }
    net.passTime(start + 1.5);
    EXPECT_EQ(itemsAndSources(net.listeners[whole].fold.state), itemsAndSources(net.relay.state()));
    net.receive(start + 1.5, "RK1 arm@a 5 105 restated part=q" + std::to_string(turn) +
                                 ":1/1 by=player reset\njoints arm 5\n");
    net.passTime(start + 2);
    EXPECT_EQ(itemsAndSources(net.listeners[filtered].fold.state),
              itemsAndSources(net.relay.state()));
  }
}

TEST(Relay, TenThousandDevicesOfAStrangerStayWithinItsLimits) {
  RelayedListeners net;
  RelayOutputOptions rate;
  rate.pacing.interval = std::chrono::seconds(1);
  net.open(rate);
  for (int turn = 0; turn < 3; ++turn) {
    for (int i = 0; i < 10'000; ++i) {
      net.receive(1 + turn * 0.1, "RK1 x - -\njoints d" + std::to_string(i) + " 1\nremove d" +
                                      std::to_string(i / 2) + "\n");
    }
  }
  net.passTime(8);
  EXPECT_EQ(itemsAndSources(net.listeners.begin()->second.fold.state),
            itemsAndSources(net.relay.state()));
}

}  // namespace
}  // namespace rocinante
