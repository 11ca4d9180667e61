#include "core/relay/filtered_output.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/relay/relay_support.h"

namespace rocinante {
namespace {

using test::itemsAndSources;
using test::RelayedListeners;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

RelayOutputOptions filteredBy(RelayFilter filter) {
  RelayOutputOptions options;
  options.filters.push_back(std::move(filter));
  return options;
}

RelayOutputOptions atMost(double hz) {
  RelayOutputOptions options;
  options.pacing.interval = Nanoseconds(static_cast<std::int64_t>(1e9 / hz));
  return options;
}

TEST(FilteredOutput, PassesTheDevicesAskedForAndNumbersWhatItSends) {
  RelayedListeners net;
  const auto id = net.open(filteredBy({{}, {"arm*"}, ~0U}));
  net.receive(1, "RK1 s@a 7 12.5\njoints arm1 1 2\njoints leg 1\nshow leg/l\nhide arm2/l\n");
  net.receive(1, "RK1 s@a 8 12.5\njoints leg 1\n");
  net.receive(1, "RK1 s@a 9 12.5\njoint arm1 a=1 b=2\nevent \"go\"\n");
  EXPECT_THAT(net.listeners[id].heard,
              ElementsAre("RK1 s@a 7 12.5 via=site:1:0\njoints arm1 1 2\nhide arm2/l\n",
                          "RK1 s@a 9 12.5 via=site:1:1\nevent \"go\"\njoint arm1 a=1 b=2\n"));
}

TEST(FilteredOutput, PassesSourcesAndKindsOfStatement) {
  RelayedListeners net;
  const auto sources = net.open(filteredBy({{"a"}, {}, ~0U}));
  const auto kinds = net.open(filteredBy({{}, {}, statementKindsOf("joints").value()}));
  net.receive(1, "RK1 a 1 -\npose d 0 0 0 0 0 0 1\norder d j\njoints d 1\n");
  net.receive(1, "RK1 b 1 -\njoints d 2\n");
  EXPECT_THAT(net.listeners[sources].heard,
              ElementsAre("RK1 a 1 - via=site:1:0\norder d j\njoint d j=1\n"
                          "pose d 0 0 0 0 0 0 1\n"));
  EXPECT_THAT(net.listeners[kinds].heard,
              ElementsAre("RK1 a 1 - via=site:2:0\norder d j\njoint d j=1\n",
                          "RK1 b 1 - via=site:2:1\njoints d 2\n"));
}

TEST(FilteredOutput, ForwardsNoPartAndRestatesByItself) {
  RelayedListeners net;
  const auto id = net.open(filteredBy({{}, {"arm"}, ~0U}));
  net.receive(1, "RK1 s 1 - restated part=x:1/1\njoints arm 1\njoints leg 1\n");
  EXPECT_THAT(net.listeners[id].heard, IsEmpty());
  net.passTime(3.5);
  EXPECT_THAT(net.listeners[id].heard,
              ElementsAre("RK1 s 1 - restated part=run.1:1/1 by=site via=site:1:0 through=site\n"
                          "order arm\njoints arm 1\n"));
}

TEST(FilteredOutput, TheNewestValueGetsThroughAtMostSoOften) {
  RelayedListeners net;
  const auto id = net.open(atMost(10));
  for (int i = 0; i <= 100; ++i) {
    net.receive(1 + i * 0.01, "RK1 s " + std::to_string(i) + " " + std::to_string(i) +
                                  "\njoints arm " + std::to_string(i) + "\n");
  }
  net.passTime(2.2);
  const auto& heard = net.listeners[id].heard;
  EXPECT_GE(heard.size(), 10U);
  EXPECT_LE(heard.size(), 12U);
  EXPECT_EQ(heard.back(),
            "RK1 s 100 100 via=site:1:" + std::to_string(heard.size() - 1) + "\njoints arm 100\n");
  EXPECT_EQ(net.relay.conflated(id), 101 - heard.size());
}

TEST(FilteredOutput, CountsWhatANewerValueReplaced) {
  RelayedListeners net;
  const auto whole = net.open();
  const auto id = net.open(atMost(10));
  net.receive(1, "RK1 s 1 -\njoints a 1\njoints b 1\ncolor a #ff0000\n");
  EXPECT_EQ(net.relay.conflated(id), 0U);
  // Held once, replaced once; of another device, held only; what is never held.
  net.receive(1.01, "RK1 s 2 -\njoints a 2\n");
  net.receive(1.02, "RK1 s 3 -\njoints a 3\njoints b 2\nevent \"e\"\nerase x\n");
  EXPECT_EQ(net.relay.conflated(id), 1U);
  net.passTime(1.5);
  EXPECT_EQ(net.relay.conflated(id), 1U);
  EXPECT_EQ(net.relay.conflated(whole), 0U);
}

TEST(FilteredOutput, WhatIsHeldWhenTheSourceIsSilentFollowsAsRestated) {
  RelayedListeners net;
  const auto id = net.open(atMost(10));
  net.receive(1, "RK1 s 1 -\njoints b 1\n");
  net.receive(1.05, "RK1 s 2 -\njoints a 1\njoints b 2\n");
  net.passTime(1.5);
  EXPECT_THAT(
      net.listeners[id].heard,
      ElementsAre("RK1 s 1 - via=site:1:0\njoints b 1\n", "RK1 s 2 - via=site:1:1\njoints a 1\n",
                  "RK1 s 2 - restated by=site via=site:1:2 through=site\njoints b 2\n"));
}

TEST(FilteredOutput, EventsEraseRemoveAndOrderAreNeverHeld) {
  RelayedListeners net;
  const auto id = net.open(atMost(1));
  for (int i = 0; i < 5; ++i) {
    net.receive(1 + i * 0.01, "RK1 s " + std::to_string(i) +
                                  " -\njoints arm 1\nevent \"e\"\nerase x\norder leg a\n"
                                  "remove tray\n");
  }
  const auto& heard = net.listeners[id].heard;
  ASSERT_EQ(heard.size(), 5U);
  EXPECT_EQ(heard[4], "RK1 s 4 - via=site:1:4\nevent \"e\"\nerase x\norder leg a\nremove tray\n");
}

// Without an order a listener takes `joints` as positions, under one as names.
TEST(FilteredOutput, HeldPositionsSurviveAnOrderThatCameAfterThem) {
  RelayedListeners net;
  const auto id = net.open(atMost(10));
  net.receive(1, "RK1 s 1 -\njoints arm 1 2\n");
  net.receive(1.01, "RK1 s 2 -\njoints arm 3 4\n");
  net.receive(1.02, "RK1 s 3 -\norder arm a b\n");
  net.passTime(1.3);
  EXPECT_EQ(itemsAndSources(net.listeners[id].fold.state), itemsAndSources(net.relay.state()));
  EXPECT_THAT(net.listeners[id].heard.back(),
              HasSubstr("order arm\njoints arm 3 4\norder arm a b"));
}

TEST(FilteredOutput, SmallChangesWaitUntilTheDeviceRests) {
  RelayedListeners net;
  RelayOutputOptions options;
  options.pacing.min_change = {0.1, 0.01, 0.1};
  const auto id = net.open(options);
  const auto& heard = net.listeners[id].heard;
  net.receive(1, "RK1 s 0 -\njoints arm 1 1\npose arm 0 0 0 0 0 0 1\n");
  for (int i = 1; i < 10; ++i) {
    net.receive(1 + i * 0.01, "RK1 s " + std::to_string(i) + " -\njoints arm 1 1.0" +
                                  std::to_string(i) + "\npose arm 0 0 0.00" + std::to_string(i) +
                                  " 0 0 0 1\n");
  }
  EXPECT_EQ(heard.size(), 1U);
  net.receive(1.2, "RK1 s 20 -\njoints arm 1 1.2\n");
  EXPECT_EQ(heard.size(), 2U);
  net.receive(1.21, "RK1 s 21 -\njoints arm 1 1.21\n");
  EXPECT_EQ(heard.size(), 2U);
  net.passTime(1.5);
  EXPECT_EQ(heard.size(), 3U);
  EXPECT_EQ(itemsAndSources(net.listeners[id].fold.state), itemsAndSources(net.relay.state()));
}

TEST(FilteredOutput, AnEventIsInTheSourcesOwnDatagramHoweverSmallTheLink) {
  RelayedListeners net;
  RelayOutputOptions options;
  options.bytes_per_second = 3600;
  const auto id = net.open(options);
  const std::string long_event(300, 'e');
  net.receive(1, "RK1 s 1 -\njoints arm 1\norder leg a\nevent \"" + long_event + "\"\n");
  EXPECT_THAT(net.listeners[id].heard[0], HasSubstr("RK1 s 1 - via=site:1:0\nevent"));
  EXPECT_EQ(net.listeners[id].fold.state.takeEvents().size(), 1U);
}

TEST(FilteredOutput, EraseIsSaidThreeTimesWhereNothingIsForgotten) {
  RelayedListeners net;
  RelayOutputOptions options;
  options.bytes_per_second = 1000;
  const auto id = net.open(options);
  int sequence = 0;
  for (int i = 0; i < 50; ++i) {
    net.receive(1, "RK1 s " + std::to_string(++sequence) + " -\nadd d" + std::to_string(i) +
                       " m\nlabel l" + std::to_string(i % 3) + " 0 0 0 \"x\"\n");
  }
  net.passTime(20);
  // This one is lost, and that one is drawn again.
  net.listeners[id].loses = [] { return true; };
  net.receive(20, "RK1 s " + std::to_string(++sequence) + " -\nerase l1\nerase l2\n");
  net.receive(20, "RK1 s " + std::to_string(++sequence) + " -\nlabel l2 0 0 0 \"new\"\n");
  net.listeners[id].loses = [] { return false; };
  net.passTime(60);
  EXPECT_EQ(itemsAndSources(net.listeners[id].fold.state), itemsAndSources(net.relay.state()));
}

}  // namespace
}  // namespace rocinante
