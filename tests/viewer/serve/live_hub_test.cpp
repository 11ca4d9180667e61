#include "viewer/serve/live_hub.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>

#include "tests/core/relay/relay_support.h"
#include "viewer/web/live_message.h"
#include "viewer/web/web_live.h"

namespace rocinante {
namespace {

ByteView viewOf(const SharedMessage& message) { return {message.data(), message.size()}; }

/// A hub, and pages that join it.
struct Hall {
  LogTime now{std::chrono::seconds(100)};
  LiveHub hub{{"serve-x", "x", 60, {}}, now};
  std::deque<WebLive> pages;

  void pass() {
    if (const SharedMessage message = hub.takeMessage(now)) {
      for (WebLive& page : pages) ASSERT_TRUE(page.take(viewOf(message)).ok());
    }
  }
  void join() {
    pass();
    WebLive& page = pages.emplace_back();
    for (const SharedMessage& message : hub.greeting(now)) {
      ASSERT_TRUE(page.take(viewOf(message)).ok());
    }
  }
  void receive(std::string_view packet) {
    hub.receive(bytesOf(packet), now);
    hub.advance(now);
    pass();
  }
  void wait(Nanoseconds time) {
    const LogTime until = now + time;
    while (now < until) {
      now += std::chrono::milliseconds(5);
      hub.advance(now);
      pass();
    }
  }
};

TEST(LiveHub, PagesHaveItsStateWheneverTheyJoin) {
  Hall hall;
  hall.join();
  for (int i = 1; i <= 200; ++i) {
    hall.receive("RK1 arm@a " + std::to_string(i) + " -\njoints arm " + std::to_string(i) + " 2\n");
    if (i == 50)
      hall.receive("RK1 cell 1 -\nline path #ff0000 0 0 0 1 1 1\npose box 1 2 3 0 0 0 1\n");
    if (i % 60 == 0) hall.join();
    hall.now += std::chrono::milliseconds(2);
  }
  hall.receive("RK1 cell 2 -\nerase path\n");
  hall.receive("RK1 arm@b 1 -\njoints arm 7 8\n");  // a restart of the source
  hall.wait(std::chrono::seconds(3));
  ASSERT_EQ(hall.pages.size(), 4U);
  for (const WebLive& page : hall.pages) {
    EXPECT_EQ(test::itemsAndSources(page.state()), test::itemsAndSources(hall.hub.state()));
  }
}

TEST(LiveHub, ManyPacketsAreFewMessages) {
  Hall hall;
  hall.join();
  std::size_t packets = 0;
  for (int i = 1; i <= 1000; ++i) {
    hall.hub.receive(
        bytesOf("RK1 arm " + std::to_string(i) + " -\njoints arm " + std::to_string(i) + "\n"),
        hall.now);
    hall.now += std::chrono::milliseconds(1);
    hall.hub.advance(hall.now);
    if (const SharedMessage message = hall.hub.takeMessage(hall.now)) {
      auto reader = *LiveMessageReader::of(viewOf(message));
      while (reader.next()) ++packets;
    }
  }
  EXPECT_GE(packets, 50U);
  EXPECT_LE(packets, 65U);
}

TEST(WebLive, WhatIsMalformedIsSaid) {
  WebLive live;
  EXPECT_FALSE(live.take({}).ok());
  Bytes message;
  beginLiveMessage(message, true, LogTime(std::chrono::seconds(5)));
  EXPECT_TRUE(live.take(message).ok());
  appendLivePacket(message, bytesOf(std::string_view("RK1 arm 1 -\njoints arm 1\n")));
  EXPECT_TRUE(live.take(message).ok());
  EXPECT_NE(live.state().findDevice("arm"), nullptr);
  for (std::size_t cut = kLiveHeadBytes + 1; cut < message.size(); ++cut) {
    EXPECT_FALSE(live.take(ByteView(message).first(cut)).ok()) << cut;
  }
  message[0] = std::byte{2};
  EXPECT_FALSE(live.take(message).ok());
}

}  // namespace
}  // namespace rocinante
