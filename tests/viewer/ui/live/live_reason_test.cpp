#include "viewer/ui/live/live_reason.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

using namespace std::chrono_literals;

LiveFacts listening(const std::string& endpoint, Nanoseconds watched) {
  LiveFacts facts;
  facts.endpoints = {Endpoint::parse(endpoint).value()};
  facts.watched = facts.silent = watched;
  return facts;
}

TEST(LiveReason, SaysNothingBeforeTwoSeconds) {
  EXPECT_FALSE(liveReason(listening("127.0.0.1:4000", 1999ms)).has_value());
}

TEST(LiveReason, NothingArrives) {
  const auto unicast = liveReason(listening("127.0.0.1:4000", 7s));
  ASSERT_TRUE(unicast.has_value());
  EXPECT_EQ(unicast->text, "nothing received on udp://127.0.0.1:4000 for 7 s");
  EXPECT_NE(unicast->hint.find("firewall"), std::string::npos);
  const auto group = liveReason(listening("239.255.19.96:19960", 3s));
  EXPECT_NE(group->hint.find("ttl"), std::string::npos);
}

TEST(LiveReason, ASubscriptionThatIsNotAnsweredSaysSo) {
  LiveFacts facts = listening("subscribe://127.0.0.1:4000?device=arm*", 3s);
  EXPECT_EQ(liveReason(facts)->text,
            "nothing received on subscribe://127.0.0.1:4000?device=arm* for 3 s");
  EXPECT_NE(liveReason(facts)->hint.find("relay"), std::string::npos);
  facts.news = "it does not answer";
  EXPECT_EQ(liveReason(facts)->hint, "it does not answer");
  facts.datagrams = 1;
  EXPECT_EQ(liveReason(facts)->hint, "it does not answer");
}

TEST(LiveReason, WhatComesIsNoPacket) {
  LiveFacts facts = listening("127.0.0.1:4000", 3s);
  facts.silent = 0s;
  facts.datagrams = facts.undecoded = 12;
  facts.undecoded_sample = "LCM\\x00";
  EXPECT_EQ(liveReason(facts)->text,
            "12 datagrams received, none of them a packet; the first begins LCM\\x00");
}

TEST(LiveReason, TheSenderStopped) {
  LiveFacts facts = listening("127.0.0.1:4000", 60s);
  facts.datagrams = 100;
  facts.devices_spoken_of = 1;
  facts.silent = 1s;
  EXPECT_FALSE(liveReason(facts).has_value());
  facts.silent = 4500ms;
  EXPECT_EQ(liveReason(facts)->text, "nothing received for the last 4 s");
}

TEST(LiveReason, OnlyMachinesAreMissed) {
  LiveFacts facts = listening("127.0.0.1:4000", 60s);
  facts.datagrams = 100;
  facts.devices_spoken_of = 1;
  facts.silent = 4500ms;
  facts.any_window = true;
  EXPECT_EQ(liveReason(facts)->text,
            "nothing received for the last 4 s, except from other windows");
  facts.only_windows = true;
  EXPECT_FALSE(liveReason(facts).has_value());
  facts.any_window = false;  // the last one has closed
  EXPECT_FALSE(liveReason(facts).has_value());
}

TEST(LiveReason, PacketsMoveNothing) {
  LiveFacts facts = listening("127.0.0.1:4000", 60s);
  facts.datagrams = 100;
  facts.silent = 0s;
  EXPECT_EQ(liveReason(facts)->text, "packets arrive, but none is about a device");
  // Those who look on together need no device to move.
  facts.only_windows = true;
  EXPECT_FALSE(liveReason(facts).has_value());
  facts.devices_spoken_of = 2;
  facts.unknown_device = "puma";
  EXPECT_EQ(liveReason(facts)->text, "the cell has no device puma, and no `add` brings it");
}

}  // namespace
}  // namespace rocinante
