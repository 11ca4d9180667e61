#include "player/playhead/playhead.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/player/playhead/deck.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::Deck;
using test::WrittenMessage;
using testing::ElementsAre;
using testing::IsEmpty;

class PlayheadTest : public testing::Test {
 protected:
  /// A deck with a log of these messages.
  Deck deck(const std::vector<WrittenMessage>& messages, const PlayheadOptions& options = {}) {
    return Deck({test::writeLog(folder_ / ("log" + std::to_string(++logs_)), messages)}, options);
  }
  test::TemporaryFolder folder_;
  int logs_ = 0;
};

const std::vector<WrittenMessage> kFour{{1s, "a"}, {2s, "b"}, {3s, "c"}, {4s, "d"}};

TEST_F(PlayheadTest, PlaysASpanHalfOpen) {
  PlayheadOptions options;
  options.span = {LogTime(2s), LogTime(4s)};
  auto deck = this->deck(kFour, options);
  deck.playFor(10s);
  EXPECT_THAT(deck.payloads(), ElementsAre("b", "c"));
  EXPECT_EQ(deck.playhead().state(), Playhead::State::ended);
}

TEST_F(PlayheadTest, NothingGoesBeforeItsTime) {
  auto deck = this->deck(kFour);
  deck.playFor(1s);
  EXPECT_THAT(deck.payloads(), ElementsAre("a"));
  deck.playFor(10ms);
  EXPECT_THAT(deck.payloads(), ElementsAre("a", "b"));
}

TEST_F(PlayheadTest, PausingStopsTheTimeAndPlayingGoesOnFromThere) {
  auto deck = this->deck(kFour);
  deck.playFor(1'505ms);
  EXPECT_EQ(deck.say("pause"), "ok t=1.500000000 state=paused speed=1 sent=2");
  deck.playFor(1h);
  EXPECT_EQ(deck.say("status"), "ok t=1.500000000 state=paused speed=1 sent=2");
  EXPECT_EQ(deck.say("toggle"), "ok t=1.500000000 state=playing speed=1 sent=2");
  deck.playFor(499ms);
  EXPECT_EQ(deck.payloads().size(), 2U);
  deck.playFor(1ms);
  EXPECT_EQ(deck.payloads().size(), 3U);
}

TEST_F(PlayheadTest, StepsVisitEachMessageAlsoAtEqualTimes) {
  PlayheadOptions options;
  options.start_paused = true;
  auto deck = this->deck({{1s, "a"}, {1s, "b"}, {1s, "c"}, {2s, "d"}}, options);
  EXPECT_THAT(deck.payloads(), IsEmpty());
  EXPECT_EQ(deck.say("step"), "ok t=0.000000000 state=paused speed=1 sent=1");
  EXPECT_THAT(deck.payloads(), ElementsAre("a"));
  deck.say("step 1");
  EXPECT_THAT(deck.payloads(), ElementsAre("a", "b"));
  EXPECT_EQ(deck.say("back 1"), "ok t=0.000000000 state=paused speed=1 sent=2");
  EXPECT_EQ(deck.say("step 2"), "ok t=0.000000000 state=paused speed=1 sent=4");
  EXPECT_THAT(deck.payloads(), ElementsAre("a", "b", "b", "c"));
  EXPECT_EQ(deck.say("step 99"), "ok t=1.000000000 state=ended speed=1 sent=5");
  EXPECT_EQ(deck.say("back 99"), "ok t=0.000000000 state=paused speed=1 sent=5");
  EXPECT_EQ(deck.say("back"), "ok t=0.000000000 state=paused speed=1 sent=5");
  deck.say("step 4");
  EXPECT_THAT(deck.payloads(), ElementsAre("a", "b", "b", "c", "d", "a", "b", "c", "d"));
}

TEST_F(PlayheadTest, PausingSurvivesASeek) {
  auto deck = this->deck(kFour);
  deck.say("pause");
  EXPECT_EQ(deck.say("seek 2.5s"), "ok t=2.500000000 state=paused speed=1 sent=0");
  deck.playFor(1min);
  EXPECT_THAT(deck.payloads(), IsEmpty());
  EXPECT_EQ(deck.say("seek 1"), "ok t=1.000000000 state=paused speed=1 sent=0");
  EXPECT_EQ(deck.say("play"), "ok t=1.000000000 state=playing speed=1 sent=0");
  deck.playFor(10s);
  EXPECT_THAT(deck.payloads(), ElementsAre("b", "c", "d"));
}

TEST_F(PlayheadTest, SeeksBeyondTheEndsStopAtThem) {
  auto deck = this->deck(kFour);
  EXPECT_EQ(deck.say("seek 100s"), "ok t=3.000000001 state=ended speed=1 sent=0");
  EXPECT_EQ(deck.say("seek -100s"), "ok t=0.000000000 state=playing speed=1 sent=0");
  EXPECT_EQ(deck.say("step 9223372036s"), "ok t=3.000000001 state=ended speed=1 sent=0");
  EXPECT_EQ(deck.say("back 9223372036s"), "ok t=0.000000000 state=playing speed=1 sent=0");
  EXPECT_EQ(deck.say("seek 1970-01-01T00:00:00Z"), "ok t=0.000000000 state=playing speed=1 sent=0");
  EXPECT_EQ(deck.say("seek 2200-01-01T00:00:00Z"), "ok t=3.000000001 state=ended speed=1 sent=0");
}

TEST_F(PlayheadTest, AtTheEndPlayBeginsAnew) {
  auto deck = this->deck(kFour);
  deck.playFor(10s);
  EXPECT_EQ(deck.say("status"), "ok t=3.000000000 state=ended speed=1 sent=4");
  EXPECT_EQ(deck.say("play"), "ok t=0.000000000 state=playing speed=1 sent=4");
  deck.playFor(10s);
  EXPECT_EQ(deck.payloads().size(), 8U);
  EXPECT_EQ(deck.say("step"), "ok t=3.000000000 state=ended speed=1 sent=8");
}

TEST_F(PlayheadTest, TheSpeedChangesWithoutAJump) {
  auto deck = this->deck({{1s, "a"}, {11s, "b"}, {21s, "c"}});
  deck.playFor(5'005ms);
  EXPECT_EQ(deck.say("speed 0.5"), "ok t=5.000000000 state=playing speed=0.5 sent=1");
  deck.playFor(2s);
  EXPECT_EQ(deck.say("speed 1000"), "ok t=6.000000000 state=playing speed=1000 sent=1");
  deck.playFor(4ms - 1ns);
  EXPECT_EQ(deck.payloads().size(), 1U);
  deck.playFor(1ns);
  EXPECT_EQ(deck.payloads().size(), 2U);
  EXPECT_EQ(deck.say("speed 0.01"), "ok t=10.000000000 state=playing speed=0.01 sent=2");
  EXPECT_EQ(deck.say("faster"), "ok t=10.000000000 state=playing speed=0.02 sent=2");
  EXPECT_EQ(deck.say("slower"), "ok t=10.000000000 state=playing speed=0.01 sent=2");
  EXPECT_EQ(deck.say("slower"), "ok t=10.000000000 state=playing speed=0.01 sent=2");
  EXPECT_EQ(deck.say("speed 1/3"), "ok t=10.000000000 state=playing speed=1/3 sent=2");
}

TEST_F(PlayheadTest, WhoeverFellBehindGoesOnInOrderAfterAChangeOfSpeed) {
  auto deck = this->deck(kFour);
  deck.sleepFor(1h);  // the machine, not the deck
  deck.say("speed 2");
  deck.playFor(10s);
  EXPECT_THAT(deck.payloads(), ElementsAre("a", "b", "c", "d"));
}

TEST_F(PlayheadTest, LoopsAPartUntilItIsToldNotTo) {
  PlayheadOptions options;
  options.restate = false;
  auto deck = this->deck(kFour, options);
  deck.playFor(0s);
  EXPECT_EQ(deck.say("loop 1s 3s"), "ok t=0.000000000 state=playing speed=1 sent=1");
  deck.playFor(5'500ms);
  EXPECT_THAT(deck.payloads(), ElementsAre("a", "b", "c", "b", "c", "b"));
  EXPECT_EQ(deck.say("loop off"), "ok t=1.500000000 state=playing speed=1 sent=6");
  deck.playFor(10s);
  EXPECT_THAT(deck.payloads(), ElementsAre("a", "b", "c", "b", "c", "b", "c", "d"));
  // After its end it starts again at its beginning.
  EXPECT_EQ(deck.say("loop 0s 1s"), "ok t=0.000000000 state=playing speed=1 sent=8");
  EXPECT_EQ(deck.say("seek 3s"), "ok t=3.000000000 state=playing speed=1 sent=8");
}

TEST_F(PlayheadTest, LoopsThatCannotBeAreRefused) {
  auto deck = this->deck(kFour);
  EXPECT_EQ(deck.say("loop 2s 2s"), "error a loop must end after it begins");
  EXPECT_EQ(deck.say("loop 0.1s 0.9s"), "error the loop contains no message");
  EXPECT_EQ(deck.say("loop 100s 200s"), "error the loop is outside the played range");
  EXPECT_EQ(deck.say("loop 2s"), "error usage: loop FROM UNTIL, or loop off");
  EXPECT_EQ(deck.say("loop -1s 100s"), "ok t=0.000000000 state=playing speed=1 sent=0");
}

TEST_F(PlayheadTest, ALoopOfOneMessageDoesNotFlood) {
  PlayheadOptions options;
  options.turns = 0;
  options.restate = false;
  auto deck = this->deck({{1s, "a"}}, options);
  deck.playFor(100ms);
  EXPECT_LE(deck.payloads().size(), 102U);
  EXPECT_GE(deck.payloads().size(), 98U);
}

TEST_F(PlayheadTest, SilencesAreCutShort) {
  PlayheadOptions options;
  options.gap_limit = 2s;
  auto deck = this->deck({{1s, "a"}, {2s, "b"}, {9'000'000s, "c"}, {9'000'001s, "d"}}, options);
  deck.playFor(3'005ms - 1ns);
  EXPECT_EQ(deck.payloads().size(), 2U);
  deck.playFor(1ns);
  EXPECT_THAT(deck.payloads(), ElementsAre("a", "b", "c"));
  deck.playFor(1s);
  EXPECT_EQ(deck.payloads().size(), 4U);
}

TEST_F(PlayheadTest, TheLimitOfASilenceIsInRealTime) {
  PlayheadOptions options;
  options.gap_limit = 2s;
  options.speed = PlaybackSpeed::parse("10").value();
  auto deck = this->deck({{1s, "a"}, {21s, "b"}, {60s, "c"}}, options);
  deck.playFor(2'005ms);
  EXPECT_THAT(deck.payloads(), ElementsAre("a", "b"));
  deck.playFor(2s);
  EXPECT_EQ(deck.payloads().size(), 3U);
}

TEST_F(PlayheadTest, EventsAreGoneToAndSent) {
  PlayheadOptions options;
  options.start_paused = true;
  auto deck = this->deck({{1s, "RK1 a - -\nadd arm m\n"},
                          {2s, "RK1 a - -\nevent \"one\"\n"},
                          {3s, "RK1 a - -\njoints arm 1\n"},
                          {3s, "RK1 a - -\nevent \"two\"\n"},
                          {4s, "RK1 a - -\njoints arm 2\n"}},
                         options);
  EXPECT_EQ(deck.say("next"), "ok t=1.000000000 state=paused speed=1 sent=1");
  EXPECT_THAT(deck.payloads().back(), testing::HasSubstr("one"));
  EXPECT_EQ(deck.say("next"), "ok t=2.000000000 state=paused speed=1 sent=3");
  EXPECT_THAT(deck.payloads().back(), testing::HasSubstr("two"));
  EXPECT_EQ(deck.say("next"), "error no event comes after this");
  EXPECT_EQ(deck.say("previous"), "ok t=1.000000000 state=paused speed=1 sent=4");
  EXPECT_EQ(deck.say("previous"), "error no event came before this");
  deck.expectStateOfPlace();
}

TEST_F(PlayheadTest, EveryStartSeekAndTurnSaysTheStateFirst) {
  PlayheadOptions options;
  options.span = {LogTime(1s), LogTime(3s)};
  options.turns = 3;
  auto deck =
      this->deck({{1s, "RK1 a - -\nadd arm m\n"}, {2s, "RK1 a - -\njoints arm 1\n"}}, options);
  deck.playFor(10s);
  EXPECT_EQ(deck.payloads().size(), 6U);
  ASSERT_GE(deck.restatements().size(), 3U);
  for (const std::string& text : deck.restatements()) {
    EXPECT_THAT(text, testing::HasSubstr("by=player reset"));
  }
  const std::vector<std::uint32_t> spans = deck.spans();
  EXPECT_THAT(spans, ElementsAre(0U, 0U, 1U, 1U, 2U, 2U));
}

TEST_F(PlayheadTest, RestatementsAreRepeatedWhilePausedAndWhilePlaying) {
  auto deck = this->deck({{1s, "RK1 a - -\nadd arm m\n"}, {100s, "RK1 a - -\njoints arm 1\n"}});
  deck.playFor(1s);
  EXPECT_EQ(deck.restatements().size(), 1U);
  deck.playFor(9s);  // a silence
  EXPECT_GE(deck.restatements().size(), 5U);
  EXPECT_LE(deck.restatements().size(), 6U);
  EXPECT_THAT(deck.restatements().back(), testing::HasSubstr("add arm m"));
  deck.say("pause");
  deck.playFor(10s);
  EXPECT_GE(deck.restatements().size(), 10U);
  deck.playFor(0s);
  PlayheadOptions busy;
  std::vector<WrittenMessage> messages;
  for (int i = 0; i < 1'000; ++i) messages.push_back({i * 10ms, "RK1 a - -\njoints arm 1\n"});
  auto second = this->deck(messages, busy);
  second.playFor(9'900ms);
  EXPECT_EQ(second.restatements().size(), 5U);
  second.say("speed 0.1");
  second.playFor(500ms);
}

TEST_F(PlayheadTest, ASourceThatSpeaksOnlyLaterIsResetToo) {
  auto deck = this->deck(
      {{1s, "RK1 a - -\nadd arm m\n", "/udp/1/a"}, {5s, "RK1 b - -\nadd hand m\n", "/udp/1/b"}});
  deck.playFor(10s);
  deck.expectStateOfPlace();
  deck.say("seek 1s");
  deck.expectStateOfPlace();
  EXPECT_FALSE(deck.receiver().devices().contains("hand") &&
               deck.receiver().devices().at("hand").presence);
}

TEST_F(PlayheadTest, WhatOthersRestatedIsSaidByThePlayer) {
  auto deck = this->deck({{1s, "RK1 a - -\njoints arm 1\n"},
                          {2s, "RK1 a - - by=relay\nadd arm m\n", "/rocinante/restated/udp/1/a"},
                          {3s, "RK1 a - -\njoints arm 2\n"}});
  deck.playFor(10s);
  EXPECT_EQ(deck.payloads().size(), 2U);
  deck.expectStateOfPlace();
}

TEST_F(PlayheadTest, OctetsHaveNothingToRestate) {
  auto deck = this->deck({{1s, std::string("\x01\x00\xff", 3)}, {2s, "plain"}});
  deck.playFor(10s);
  EXPECT_THAT(deck.payloads(), ElementsAre(std::string("\x01\x00\xff", 3), "plain"));
}

TEST_F(PlayheadTest, InLockstepEachMessageWaitsForItsAck) {
  PlayheadOptions options;
  options.speed.reset();
  options.lockstep = true;
  auto deck = this->deck(kFour, options);
  deck.playFor(1min);
  EXPECT_THAT(deck.payloads(), IsEmpty());
  EXPECT_EQ(deck.playhead().lockstep().awaited(), 0U);
  deck.say("status");
  deck.playFor(1min);
  EXPECT_THAT(deck.payloads(), ElementsAre("a"));
  EXPECT_EQ(deck.playhead().lockstep().awaited(), 1U);
  EXPECT_EQ(deck.say("ack 2"), "error step 2 has not been sent yet");
  EXPECT_THAT(deck.payloads(), ElementsAre("a"));
  deck.say("ack 1");
  deck.playFor(0s);
  EXPECT_THAT(deck.payloads(), ElementsAre("a", "b"));
  EXPECT_EQ(deck.say("speed 2"), "error the speed cannot change: nothing is sent on a schedule");
}

TEST_F(PlayheadTest, WithoutAScheduleAllIsDueAtOnce) {
  PlayheadOptions options;
  options.speed.reset();
  auto deck = this->deck(kFour, options);
  deck.playFor(0s);
  EXPECT_EQ(deck.payloads().size(), 4U);
  EXPECT_EQ(deck.say("status"), "ok t=3.000000000 state=ended speed=asap sent=4");
}

TEST_F(PlayheadTest, SeveralLogsLieOnOneLine) {
  const auto a = test::writeLog(folder_ / "a", {{1s, "a1"}, {2s, "a2"}, {2s, "a2'"}, {9s, "a9"}});
  const auto b = test::writeLog(folder_ / "b", {{2s, "b2"}, {3s, "b3"}});
  PlayheadOptions options;
  options.start_paused = true;
  Deck deck({a, b}, options);
  deck.say("step 99");
  EXPECT_THAT(deck.payloads(), ElementsAre("a1", "a2", "a2'", "b2", "b3", "a9"));
  deck.say("back 3");
  deck.say("step 1");
  EXPECT_EQ(deck.payloads().back(), "b2");
  deck.say("back 2");
  deck.say("step 1");
  EXPECT_EQ(deck.payloads().back(), "a2'");
}

}  // namespace
}  // namespace rocinante
