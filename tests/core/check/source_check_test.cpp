// What a check says of the sources that send, apart from what they move.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/packet/decoder.h"
#include "tests/core/check/session_check_test.h"

namespace rocinante {
namespace {

using test::SessionCheckTest;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST_F(SessionCheckTest, CountsFaultsOfPacketTextByKind) {
  say("joints arm 0 0 0\njoints arm 0 nan 0\njoints arm 0 x 0\nwobble arm");
  session_->add(now_, "rk1", true, bytesOf("RK1 me@a oops 3\njoints arm 0 0 0\n"));
  const CheckReport found = report();
  EXPECT_THAT(rules(found), ElementsAre("packet.bad-header", "packet.bad-number",
                                        "packet.not-finite", "packet.unknown-statement"));
  EXPECT_EQ(found.findings[1].count, 1U);
  EXPECT_EQ(found.findings[1].example, "joints arm 0 x 0");
  EXPECT_EQ(found.findings[1].text, "lines with a malformed number; the first at column 14");
  EXPECT_EQ(found.findings[2].example, "joints arm 0 nan 0");
  EXPECT_EQ(found.packets, 1U);
  EXPECT_EQ(found.datagrams, 2U);
}

TEST_F(SessionCheckTest, CountsGapsLatePacketsAndRestarts) {
  say("me@a 0 1", "joints arm 0 0 0");
  say("me@a 5 1", "joints arm 0 0 0");
  say("me@a 5 1", "joints nobody 0 0 0");  // dropped whole and not judged
  say("me@b 0 1", "joints arm 0 0 0");
  const CheckReport found = report();
  ASSERT_THAT(rules(found), ElementsAre("source.gap", "source.duplicate", "source.restart"));
  EXPECT_EQ(found.findings[0].count, 4U);
  EXPECT_EQ(found.findings[0].packet, 2U);
  EXPECT_EQ(found.verdict, CheckVerdict::compatible);
}

TEST_F(SessionCheckTest, RunsThatTakeTurnsAreTwoSenders) {
  for (int i = 0; i < 250; ++i) {
    now_ += std::chrono::milliseconds(4);
    for (const std::string_view run : {"a", "b"}) {
      session_->add(now_, "rk1", true, bytesOf(fmt::format("RK1 me@{} {} -\n", run, i)),
                    run == "a" ? "10.0.0.1:4000" : "10.0.0.1:4001");
    }
  }
  const CheckReport found = report();
  ASSERT_THAT(rules(found), ElementsAre("device.undriven", "source.two-senders"));
  EXPECT_EQ(found.findings[1].count, 498U);
  EXPECT_EQ(found.findings[1].example, "RUN b from 10.0.0.1:4001; RUN a from 10.0.0.1:4000");
  EXPECT_EQ(found.verdict, CheckVerdict::incompatible);
  // Forgotten and followed on: a watch tells it again only while it goes on.
  session_->dropFindings();
  EXPECT_THAT(rules(report()), ElementsAre("device.undriven"));
  say("me@a 300 -", "");
  EXPECT_THAT(rules(report()), ElementsAre("device.undriven", "source.two-senders"));
}

TEST_F(SessionCheckTest, ARestartWithAPacketThatWasOvertakenIsOneSender) {
  say("me@a 0 -", "joint arm shoulder=0");
  say("me@b 0 -", "joint arm shoulder=0");
  say("me@a 1 -", "joint arm shoulder=0");
  for (int i = 1; i < 9; ++i) say(fmt::format("me@b {} -", i), "joint arm shoulder=0");
  EXPECT_THAT(rules(report()), ElementsAre("source.restart"));
}

TEST_F(SessionCheckTest, APlayerThatLoopsIsOneSender) {
  for (int loop = 0; loop < 5; ++loop) {
    say("me@a 0 - by=play reset restated", "");
    for (const std::string_view run : {"a", "b"}) {
      for (int i = 1; i < 5; ++i) say(fmt::format("me@{} {} -", run, i), "joint arm shoulder=0");
    }
  }
  EXPECT_THAT(rules(report()), ElementsAre("joint.undriven", "source.restart"));
}

TEST_F(SessionCheckTest, ASilenceFollowsFromTheRateAndEndsWithTheSession) {
  const auto send = [&](std::string_view source) {
    session_->add(now_, "rk1", true,
                  bytesOf(fmt::format("RK1 {} - -\njoint arm {}=0\n", source,
                                      source == "a" ? "shoulder" : "elbow")));
  };
  for (int i = 0; i < 600; ++i) {
    now_ += std::chrono::microseconds(16'667);
    if (i < 480) send("a");
    if (i % 6 == 0) send("b");
  }
  // A recorder that runs on restates what it knows: the session is over.
  session_->add(now_ + std::chrono::seconds(2), "rk1", false,
                bytesOf("RK1 b - - by=rec restated\n"));
  const CheckReport found = report();
  const auto silence = std::ranges::find(found.findings, "source.silence", &Finding::rule);
  ASSERT_NE(silence, found.findings.end());
  EXPECT_EQ(silence->subject, "a");
  EXPECT_EQ(silence->count, 1U);
  EXPECT_THAT(silence->text, HasSubstr("a was silent for 1.9"));
  EXPECT_EQ(silence->last, now_ - std::chrono::microseconds(5 * 16'667)) << "b's last packet";
  EXPECT_NEAR(static_cast<double>((*silence->last - *silence->first).count()) * 1e-9, 1.92, 0.01);
  EXPECT_EQ(std::ranges::count(rules(found), "source.silence"), 1);
}

TEST_F(SessionCheckTest, ASourceThatOnlyRestatesWhileNothingMovesIsNotSilent) {
  for (int i = 0; i < 30; ++i) {
    for (int packet = 0; packet < 50; ++packet) {
      now_ += std::chrono::milliseconds(16);
      say("me - -", "joint arm shoulder=0");
    }
    for (int idle = 0; idle < 3; ++idle) {
      now_ += std::chrono::seconds(2);
      say("me - - restated", "joint arm shoulder=0");
    }
    now_ += std::chrono::seconds(1);
  }
  EXPECT_EQ(std::ranges::count(rules(report()), "source.silence"), 0);
}

TEST_F(SessionCheckTest, PacketsInBurstsAreNotSilentBetweenThem) {
  for (int burst = 0; burst < 30; ++burst) {
    now_ += std::chrono::milliseconds(900);
    for (int i = 0; i < 30; ++i) say("me - -", "joint arm shoulder=0");
  }
  EXPECT_EQ(std::ranges::count(rules(report()), "source.silence"), 0);
}

TEST_F(SessionCheckTest, StateThatIsSaidAgainAndAgainIsRestatedWithoutTheWord) {
  const auto send = [&](std::string_view statements) {
    now_ += std::chrono::milliseconds(99);
    say("me - -", statements);
  };
  for (int i = 0; i < 300; ++i) send("color arm #ff0000\nshow arm\njoint arm shoulder=0");
  EXPECT_EQ(std::ranges::count(rules(report()), "source.unrestated"), 0);
  // One of them is said no more.
  for (int i = 0; i < 300; ++i) send("color arm #ff0000\njoint arm shoulder=0");
  EXPECT_EQ(std::ranges::count(rules(report()), "source.unrestated"), 1);
}

TEST_F(SessionCheckTest, PublishersOfOneTopicHaveClocksOfTheirOwn) {
  const auto publish = [&](std::string_view device, double time_s) {
    session_->add(now_, "rk1", false,
                  bytesOf(fmt::format("RK1 tf - {:.3f}\npose {} 0 0 0 0 0 0 1\n", time_s, device)));
  };
  for (int i = 0; i < 300; ++i) {
    now_ += std::chrono::milliseconds(50);
    const double time_s = 1'700'000'000 + 0.05 * i;
    publish("arm", time_s);
    publish("spare", time_s - 2);
  }
  EXPECT_EQ(std::ranges::count(rules(report()), "source.clock-step"), 0);
  publish("arm", 1'700'000'000);
  publish("spare", 1'700'000'000);
  const CheckReport found = report();
  std::vector<std::string> texts;
  for (const Finding& finding : found.findings) {
    if (finding.rule != "source.clock-step") continue;
    texts.push_back(finding.text);
    EXPECT_EQ(finding.count, 1U);
  }
  EXPECT_THAT(texts, ::testing::UnorderedElementsAre(HasSubstr("in what is sent of arm"),
                                                     HasSubstr("in what is sent of spare")));
}

TEST_F(SessionCheckTest, AMisspeltStatementIsAWarningWithTheRightWord) {
  say("joint arm shoulder=0\ncolour arm ff0000ff\nflash arm 3");
  const CheckReport found = report();
  const auto misspelt =
      std::ranges::find(found.findings, "packet.misspelt-statement", &Finding::rule);
  ASSERT_NE(misspelt, found.findings.end());
  EXPECT_EQ(misspelt->severity, Severity::warning);
  EXPECT_EQ(misspelt->hint, "did you mean `color`?");
  EXPECT_EQ(std::ranges::count(rules(found), "packet.unknown-statement"), 1) << "flash";
}

}  // namespace
}  // namespace rocinante
