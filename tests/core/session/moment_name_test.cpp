#include "core/session/moment_name.h"

#include <gtest/gtest.h>

#include "tests/core/log/log_support.h"

namespace rocinante {
namespace {

using test::makeWriter;
using test::openLog;

LogTime at(int seconds) { return LogTime(std::chrono::seconds(1'000 + seconds)); }

/// Ten seconds with events: picked at 2 s, placed at 4 s and 6 s, 3s at 8 s.
Bytes written() {
  Bytes file;
  LogWriter writer = makeWriter(file, {});
  const ChannelId packets = *writer.addChannel("/udp/1/arm", "rk1", {});
  const auto say = [&](int second, const std::string& statement) {
    const std::string text = "RK1 arm - -\n" + statement;
    EXPECT_TRUE(writer.write(packets, 0, at(second), 0, bytesOf(text)).ok());
  };
  say(0, "joints arm 0");
  say(2, "event \"picked\"");
  say(4, "event \"placed\"");
  say(6, "event \"placed\"");
  say(8, "event \"3s\"");
  say(10, "joints arm 1");
  EXPECT_TRUE(writer.close("finished").ok());
  return file;
}

Timeline session() {
  static const Bytes file = written();
  return Timeline::of(openLog(file));
}

std::string faultOf(std::string_view text) {
  Timeline log = session();
  const auto moment = parseMoment(text, log);
  EXPECT_FALSE(moment.ok()) << text;
  return moment.ok() ? "" : moment.error().what;
}

TEST(MomentName, IsATimeOrAnEvent) {
  Timeline log = session();
  EXPECT_EQ(*parseMoment("2.5s", log), at(2) + std::chrono::milliseconds(500));
  EXPECT_EQ(*parseMoment("-1s", log), at(9));
  EXPECT_EQ(*parseMoment("picked", log), at(2));
  EXPECT_EQ(*parseMoment("pick*", log), at(2));
  EXPECT_EQ(*momentOfEvent("picked", log), at(2));
  // A time is a time, also when an event has that text.
  EXPECT_EQ(*parseMoment("3s", log), at(3));
  EXPECT_EQ(*momentOfEvent("3s", log), at(8));
  StateDamage hiding;
  EXPECT_EQ(eventsNamed("p*", log, hiding)->size(), 3U);
  EXPECT_TRUE(hiding.empty());
}

TEST(MomentName, OfSeveralEventsNoneIsChosenInSilence) {
  EXPECT_EQ(faultOf("placed"), "2 events are named `placed`, at 4.000 s, 6.000 s: give the time");
}

TEST(MomentName, WhatIsNeitherIsToldAsBoth) {
  const std::string fault = faultOf("pickd");
  EXPECT_NE(fault.find("a time is 12.5s"), std::string::npos) << fault;
  EXPECT_NE(fault.find("no event of the log is named `pickd`: did you mean `picked`?"),
            std::string::npos)
      << fault;
  EXPECT_TRUE(isSessionTime("12.5"));
  EXPECT_TRUE(isSessionTime("-1s"));
  EXPECT_TRUE(isSessionTime("2026-02-03T04:05:06Z"));
  EXPECT_FALSE(isSessionTime("picked"));
  EXPECT_FALSE(isSessionTime("picked-up"));
  EXPECT_FALSE(isSessionTime(""));
}

}  // namespace
}  // namespace rocinante
