#include "player/playhead/playhead_sender.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>

#include "player/playhead/play_line_text.h"
#include "player/send/play_report.h"
#include "tests/player/logs/written_log.h"
#include "tests/player/send/fake_send_port.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::FakeJournal;
using test::FakeSendPort;
using testing::ElementsAre;

/// Commands that wait from the start, and their answers.
class FakeCommands final : public CommandSource {
 public:
  explicit FakeCommands(std::deque<std::string> lines) : lines_(std::move(lines)) {}

  std::optional<std::string_view> asked() override {
    if (lines_.empty()) return std::nullopt;
    return lines_.front();
  }
  void answer(std::string line) override {
    if (!line.empty()) answers.push_back(std::move(line));
    lines_.pop_front();
  }
  void tell(std::string line) override { told.push_back(std::move(line)); }

  std::vector<std::string> answers, told;

 private:
  std::deque<std::string> lines_;
};

class SendPlayheadTest : public testing::Test {
 protected:
  Result<SendEnd> send(const std::vector<test::WrittenMessage>& messages, PlayheadOptions options,
                       FakeSendPort& edge, SendJournal& journal, CommandSource* commands = nullptr,
                       bool stays = false) {
    const std::vector<std::filesystem::path> logs{test::writeLog(folder_ / "log", messages)};
    MultiLogReader tape = MultiLogReader::open(logs).value();
    TapeFinder finder = TapeFinder::open(logs, {}).value();
    const PlayRoutes routes = makeRoutes(tape, Endpoint::standard(), {}, false).value();
    if (options.span.until == LogTime{}) options.span = {tape.start(), tape.end() + 1ns};
    options.origin = tape.origin();
    options.end = tape.end();
    options.read_ahead = false;
    auto playhead = Playhead::open(tape, finder, routes, options, edge.now()).value();
    const PlayheadRules rules{stays, tape.origin(), tape.end(),
                              1s,    nullptr,       [&](auto line) { told_.emplace_back(line); }};
    return sendPlayhead(*playhead, rules, edge, journal, commands, status_);
  }
  test::TemporaryFolder folder_;
  PlayStatus status_;
  std::vector<std::string> told_;
};

const std::vector<test::WrittenMessage> kThree{{1s, "a"}, {2s, "b"}, {3s, "c"}};

TEST_F(SendPlayheadTest, SendsEverythingInOrderAndNothingEarly) {
  FakeSendPort edge;
  FakeJournal journal;
  EXPECT_EQ(send(kThree, {}, edge, journal).value(), SendEnd::finished);
  EXPECT_THAT(edge.sent, testing::IsSupersetOf({"a", "b", "c"}));
  for (const auto& line : journal.lines) {
    if (line.due.restated) continue;
    EXPECT_GE(line.sent_at, line.deadline);
    EXPECT_LT(line.sent_at - line.deadline, 20us);
  }
}

TEST_F(SendPlayheadTest, SaysHowLongALongSilenceLastsAndHowToPassIt) {
  FakeSendPort edge;
  FakeJournal journal;
  ASSERT_TRUE(send({{1s, "a"}, {61s, "b"}, {7'361s, "c"}}, {}, edge, journal).ok());
  EXPECT_THAT(
      told_, testing::ElementsAre("silent for 2.0 hours, until 7360.000 s: --gap-limit 2s shortens "
                                  "silences, --from 7360.000s begins behind it"));
}

TEST_F(SendPlayheadTest, SaysNothingOfASilenceThatIsShortened) {
  FakeSendPort edge;
  FakeJournal journal;
  PlayheadOptions options;
  options.gap_limit = 2s;
  ASSERT_TRUE(send({{1s, "a"}, {1'700'000'000s, "c"}}, options, edge, journal).ok());
  EXPECT_THAT(told_, testing::IsEmpty());
}

TEST_F(SendPlayheadTest, RestatementsLeaveByASocketOfTheirOwn) {
  FakeSendPort edge;
  FakeJournal journal;
  ASSERT_TRUE(send({{1s, "RK1 a - -\nadd arm m\n"}, {2s, "b"}}, {}, edge, journal).ok());
  ASSERT_EQ(edge.sent.size(), edge.routes.size());
  for (std::size_t i = 0; i < edge.sent.size(); ++i) {
    EXPECT_EQ(edge.routes[i] != edge.routes.back(), journal.lines[i].due.restated);
  }
}

TEST_F(SendPlayheadTest, AnHourInTurnsEndsOnTheExactNanosecondAtEverySpeed) {
  // 6,000 a second in the first second of every minute, and one at its very end; sixty turns.
  std::vector<test::WrittenMessage> minute;
  for (std::int64_t i = 0; i < 6'000; ++i) {
    minute.push_back({1s + Nanoseconds(i * 1'000'000'000 / 6'000), "packet"});
  }
  minute.push_back({61s - 1ns, "last"});
  struct Last final : SendJournal {
    void sent(const Due& due, ByteView, SteadyTime deadline, SteadyTime sent_at) override {
      if (count == 0) first = deadline;
      ++count;
      early += sent_at < deadline;
      // The time on the line is exact; so must the deadline be, in every turn.
      const Nanoseconds at = due.place.time - LogTime(1s) + due.span * Nanoseconds(1min);
      wrong += deadline - first != speed.realDuration(at);
      last = deadline;
    }
    PlaybackSpeed speed;
    int count = 0, early = 0, wrong = 0;
    SteadyTime first{}, last{};
  };
  const std::pair<const char*, Nanoseconds> ends[] = {{"0.1", 10h - 10ns},
                                                      {"1", 1h - 1ns},
                                                      {"2", 30min - 1ns},
                                                      {"3", 20min - 1ns},
                                                      {"7", 3'599'999'999'999ns / 7},
                                                      {"10", 6min - 1ns}};
  for (const auto& [speed, end] : ends) {
    SCOPED_TRACE(speed);
    std::filesystem::remove(folder_ / "log");
    PlayheadOptions options;
    options.span = {LogTime(1s), LogTime(61s)};
    options.turns = 60;
    options.restate = false;
    options.speed = PlaybackSpeed::parse(speed).value();
    FakeSendPort edge;
    edge.keep_payloads = false;
    edge.look_costs = 2us;
    edge.wakes_late = 15us;
    Last last;
    last.speed = *options.speed;
    EXPECT_EQ(send(minute, options, edge, last).value(), SendEnd::finished);
    EXPECT_EQ(last.count, 60 * 6'001);
    EXPECT_EQ(last.early, 0);
    EXPECT_EQ(last.wrong, 0);
    EXPECT_EQ(last.last - last.first, end);
  }
}

TEST_F(SendPlayheadTest, AnswersWhenWhatWasAskedForIsDone) {
  PlayheadOptions options;
  options.start_paused = true;
  FakeSendPort edge;
  FakeJournal journal;
  FakeCommands commands({"step 2", "nonsense", "back", "quit"});
  EXPECT_EQ(send(kThree, options, edge, journal, &commands, true).value(), SendEnd::stopped);
  EXPECT_THAT(commands.answers, ElementsAre("ok t=1.000000000 state=paused speed=1 sent=2",
                                            "error unknown command nonsense",
                                            "ok t=0.000000000 state=paused speed=1 sent=2",
                                            "ok t=0.000000000 state=paused speed=1 sent=2"));
}

TEST_F(SendPlayheadTest, AtTheEndItStaysForCommandsWhenToldTo) {
  FakeSendPort edge;
  edge.stop_after_sends = 200;
  FakeJournal journal;
  FakeCommands commands({"seek 100s", "status"});
  EXPECT_EQ(send(kThree, {}, edge, journal, &commands, true).value(), SendEnd::stopped);
  EXPECT_THAT(commands.answers.back(), testing::HasSubstr("state=ended"));
}

TEST_F(SendPlayheadTest, TimeInWhichTheProcessWasStoppedIsNotMadeUpFor) {
  PlayheadOptions options;
  options.restate = false;
  FakeSendPort edge;
  edge.stopped_after_sends = 1;
  edge.stopped_for = 1h;
  FakeJournal journal;
  ASSERT_EQ(send(kThree, options, edge, journal).value(), SendEnd::finished);
  EXPECT_THAT(edge.sent, ElementsAre("a", "b", "c"));
  for (const auto& line : journal.lines) EXPECT_LT(line.sent_at - line.deadline, 20us);
  EXPECT_GE(journal.lines[1].sent_at - journal.lines[0].sent_at, 1h + 999ms);
  EXPECT_GE(journal.lines[2].sent_at - journal.lines[1].sent_at, 999ms);
}

TEST_F(SendPlayheadTest, ANetworkThatGoesAwayIsAnErrorAfterWhatWasSent) {
  FakeSendPort edge;
  FakeJournal journal;
  PlayheadOptions options;
  options.restate = false;
  edge.fail_send = 3;
  const auto end = send(kThree, options, edge, journal);
  ASSERT_FALSE(end.ok());
  EXPECT_EQ(end.error().what, "the network is gone");
  EXPECT_THAT(journal.payloads, ElementsAre("a", "b"));
}

TEST_F(SendPlayheadTest, WithoutAnAckItGivesUp) {
  FakeSendPort edge;
  FakeJournal journal;
  PlayheadOptions options;
  options.lockstep = true;
  options.speed.reset();
  FakeCommands commands({"status", "status", "status"});
  const auto end = send(kThree, options, edge, journal, &commands);
  ASSERT_FALSE(end.ok());
  EXPECT_EQ(end.error().what, "ack 1 did not arrive within --ack-timeout");
  EXPECT_THAT(commands.told, ElementsAre("step 1"));
}

TEST_F(SendPlayheadTest, PausedItSleepsUntilItRestatesOrLooksForASignal) {
  PlayheadOptions options;
  options.start_paused = true;
  options.repeat = 10s;
  FakeSendPort edge;
  edge.stop_after_sends = 7;  // the state of the start, and six times again
  FakeJournal journal;
  FakeCommands commands({});
  EXPECT_EQ(send(kThree, options, edge, journal, &commands, true).value(), SendEnd::stopped);
  EXPECT_EQ(edge.sends, 7U);
  EXPECT_GE(edge.slept, 59s);
  EXPECT_LE(edge.slept, 61s);
  EXPECT_LE(edge.sleeps, 2U * 61U);
  EXPECT_LE(edge.longest_sleep, 500ms);
}

TEST_F(SendPlayheadTest, ASpanThatWasLeftIsReportedAsLongAsItWasPlayed) {
  PlayheadOptions options;
  options.start_paused = true;
  FakeSendPort edge;
  PlayJournal journal(LogTime(1s), LogTime(3s + 1ns));
  FakeCommands commands({"step 2", "seek 0s", "seek 2s", "step 1", "quit"});
  ASSERT_TRUE(send(kThree, options, edge, journal, &commands, true).ok());
  PlayReport report;
  journal.writeTo(report, false);
  ASSERT_EQ(report.spans.size(), 2U);
  EXPECT_EQ(report.spans[0].from, LogTime(1s));
  EXPECT_EQ(report.spans[0].until, LogTime(2s + 1ns));
  EXPECT_EQ(report.spans[0].sent, 2U);
  EXPECT_EQ(report.spans[1].from, LogTime(3s));
  EXPECT_EQ(report.spans[1].until, LogTime(3s + 1ns));
  EXPECT_EQ(report.spans[1].sent, 1U);
}

TEST(PlayLineText, CountsDownInALongSilence) {
  PlayStatus status;
  status.position_ns = 2'500'000'000;
  status.sent = 7;
  status.next_ns = 61'000'000'000;
  EXPECT_EQ(playLineText(status, LogTime(1s), LogTime(100s), SteadyTime(1s)),
            "1.5 of 99.0 s, 7 datagrams, silent for 60.0 s more");
  status.speed = 0.5;
  status.state = 1;
  EXPECT_EQ(playLineText(status, LogTime(1s), LogTime(100s), SteadyTime(1s)),
            "1.5 of 99.0 s, 7 datagrams, 0.5x, paused");
}

}  // namespace
}  // namespace rocinante
