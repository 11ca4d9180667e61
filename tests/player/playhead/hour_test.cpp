// An hour of 6,000 datagrams a second with a clock that advances only while waiting.
#include <gtest/gtest.h>

#include <cstdlib>

#include "player/playhead/playhead_sender.h"
#include "player/send/play_report.h"
#include "tests/player/logs/written_log.h"
#include "tests/player/send/fake_send_port.h"
#include "tests/support/process_memory.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

constexpr std::int64_t kHourRate = 6'000;
constexpr std::uint32_t kTurns = 60;
constexpr LogTime kStart{1s};
constexpr Nanoseconds kTurn = 1min;

/// A minute at 6,000 a second, and one at its very end.
std::vector<test::WrittenMessage> minute() {
  std::vector<test::WrittenMessage> messages;
  for (std::int64_t i = 0; i < kHourRate * 60; ++i) {
    const Nanoseconds at(i * 1'000'000'000 / kHourRate);
    messages.push_back(
        {kStart.time_since_epoch() + at,
         "RK1 arm@r1 " + std::to_string(i) + " -\njoints arm 0.125 1 2 3 4 " + std::to_string(i)});
  }
  messages.push_back({kStart.time_since_epoch() + kTurn - 1ns, "RK1 arm@r1 - -\njoints arm 1"});
  return messages;
}

/// Checks each deadline with independent arithmetic (an hour times ten fits 64 bits), and passes it
/// on.
class ExactJournal final : public SendJournal {
 public:
  ExactJournal(PlayJournal& behind, std::int64_t log_part, std::int64_t real_part)
      : behind_(behind), log_part_(log_part), real_part_(real_part) {}

  void sent(const Due& due, ByteView payload, SteadyTime deadline, SteadyTime sent_at) override {
    behind_.sent(due, payload, deadline, sent_at);
    if (due.restated) return;
    if (count == 0) first = deadline;
    const Nanoseconds at = due.place.time - kStart + due.span * kTurn;
    const auto exact = at.count() * real_part_ / log_part_;
    wrong += (deadline - first).count() != exact;
    early += sent_at < deadline;
    last = deadline;
    // After a minute all blocks kept for reuse exist.
    if (++count == 5'000'000) bytes_early = test::anonymousBytes();
  }

  std::uint64_t count = 0, wrong = 0, early = 0, bytes_early = 0;
  SteadyTime first{}, last{};

 private:
  PlayJournal& behind_;
  std::int64_t log_part_, real_part_;
};

TEST(PlayHour, EndsOnTheExactNanosecondAtEverySpeedAndInConstantMemory) {
  if (std::getenv("ROCINANTE_NIGHTLY") == nullptr) {
    GTEST_SKIP() << "takes minutes; ROCINANTE_NIGHTLY=1 runs it";
  }
  const test::TemporaryFolder folder;
  const std::vector<std::filesystem::path> logs{test::writeLog(folder / "log", minute())};
  struct Speed {
    const char* text;
    std::int64_t log_part, real_part;
  };
  for (const Speed& speed : {Speed{"0.1", 1, 10}, Speed{"1", 1, 1}, Speed{"2", 2, 1},
                             Speed{"3", 3, 1}, Speed{"7", 7, 1}, Speed{"10", 10, 1}}) {
    SCOPED_TRACE(speed.text);
    MultiLogReader tape = MultiLogReader::open(logs).value();
    TapeFinder finder = TapeFinder::open(logs, {}).value();
    const PlayRoutes routes = makeRoutes(tape, Endpoint::standard(), {}, false).value();
    PlayheadOptions options;
    options.span = {kStart, kStart + kTurn};
    options.turns = kTurns;
    options.origin = tape.origin();
    options.end = tape.end();
    options.speed = PlaybackSpeed::parse(speed.text).value();
    test::FakeSendPort edge;
    edge.keep_payloads = false;
    edge.look_costs = 15us;  // a spin takes few clock readings
    edge.send_costs = 100ns;
    auto playhead = Playhead::open(tape, finder, routes, options, edge.now()).value();
    PlayJournal report(options.span.from, options.span.until);
    ExactJournal journal(report, speed.log_part, speed.real_part);
    PlayStatus status;
    const PlayheadRules rules{false, tape.origin(), tape.end()};
    EXPECT_EQ(sendPlayhead(*playhead, rules, edge, journal, nullptr, status).value(),
              SendEnd::finished);
    const std::uint64_t bytes_late = test::anonymousBytes();

    EXPECT_EQ(journal.count, kTurns * (kHourRate * 60 + 1));
    EXPECT_EQ(journal.wrong, 0U);
    EXPECT_EQ(journal.early, 0U);
    EXPECT_EQ((journal.last - journal.first).count(),
              (kTurns * kTurn - 1ns).count() * speed.real_part / speed.log_part);
    // The size of the read-ahead; a byte for each datagram would be four times that.
    EXPECT_LT(bytes_late, journal.bytes_early + (4U << 20U));
    std::printf("%sx: %lu datagrams, %.3f s; %.1f MiB at first, %.1f at last\n", speed.text,
                journal.count, std::chrono::duration<double>(journal.last - journal.first).count(),
                static_cast<double>(journal.bytes_early) / (1 << 20),
                static_cast<double>(bytes_late) / (1 << 20));
  }
}

}  // namespace
}  // namespace rocinante
