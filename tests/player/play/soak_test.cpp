// A session played into a recorder for a chosen time, at 6,000 datagrams a second.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sched.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "core/log/log_reader.h"
#include "tests/player/logs/written_log.h"
#include "tests/support/process_memory.h"
#include "tests/support/programs.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::Program;

constexpr std::int64_t kRate = 6'000;

/// How long: ROCINANTE_SOAK_SECONDS, or a quarter of a minute.
std::chrono::seconds soakTime() {
  const char* const text = std::getenv("ROCINANTE_SOAK_SECONDS");
  return std::chrono::seconds(text == nullptr ? 15 : std::max(5, std::atoi(text)));
}

/// A private network namespace with only a loopback; without the rights, the usual network.
void enterOwnNetwork() {
  if (::unshare(CLONE_NEWNET) != 0) return;
  if (std::system("ip link set lo up") != 0) FAIL() << "no loopback in a namespace of its own";
}

/// Five seconds of six joints.
std::filesystem::path writeSession(const std::filesystem::path& path) {
  std::vector<test::WrittenMessage> messages;
  for (std::int64_t i = 0; i < 5 * kRate; ++i) {
    const double q = static_cast<double>(i) * 1e-4;
    messages.push_back({1s + Nanoseconds(i * 1'000'000'000 / kRate),
                        fmt::format("RK1 arm@r1 {} -\njoints arm {:.5f} {:.5f} {:.5f} 0 1 {:.5f}",
                                    i, q, q / 2, 1 - q, q / 3)});
  }
  return test::writeLog(path, messages);
}

/// Without other load: memory, lateness and losses depend on what else a machine does.
bool isNightly() { return std::getenv("ROCINANTE_NIGHTLY") != nullptr; }

struct Memory {
  std::uint64_t early = 0, late = 0;

  void expectConstant(const char* whose) const {
    std::printf("%s: %.1f MiB at first, %.1f MiB at last\n", whose,
                static_cast<double>(early) / (1 << 20), static_cast<double>(late) / (1 << 20));
    EXPECT_GT(early, 0U);
    if (isNightly()) {
      EXPECT_LT(late, early + (4U << 20U));
    }
  }
};

TEST(PlaySoak, ARecorderKeepsAllThatAPlayerSendsInConstantMemoryAndWithoutDrift) {
  if (std::getenv("ROCINANTE_LONG") == nullptr) {
    GTEST_SKIP() << "takes 15 s; ROCINANTE_LONG=1 runs it";
  }
  enterOwnNetwork();
  const test::TemporaryFolder folder;
  const auto session = writeSession(folder / "session.mcap");
  const auto log = folder / "recorded.mcap";
  Program recorder = Program::start("rocinante-record", {"127.0.0.1:0", "-o", log.string()});
  const std::string line = recorder.waitForLine("recording udp://");
  const std::size_t begin = line.find("udp://");
  ASSERT_NE(begin, line.npos);
  const std::string endpoint = line.substr(begin, line.find(' ', begin) - begin);

  const std::int64_t turns = soakTime() / 5s;
  Program player = Program::start(
      "rocinante-play", {session.string(), "--to", endpoint, "--from", "0s", "--until", "5s",
                         "--loop", std::to_string(turns), "--report", "-"});
  player.waitForLine("playing ");
  Memory played, recorded;
  std::this_thread::sleep_for(soakTime() / 3);
  played.early = test::anonymousBytes(player.pid());
  recorded.early = test::anonymousBytes(recorder.pid());
  std::this_thread::sleep_for(soakTime() * 2 / 3 - 1s);
  played.late = test::anonymousBytes(player.pid());
  recorded.late = test::anonymousBytes(recorder.pid());
  const auto result = player.finish(60s);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const auto kept = recorder.stop();
  EXPECT_EQ(kept.exit_code, 0) << kept.err;
  played.expectConstant("player");
  recorded.expectConstant("recorder");

  const auto report = nlohmann::json::parse(result.out, nullptr, false);
  ASSERT_FALSE(report.is_discarded()) << result.out;
  const std::int64_t sent = report["sent"];
  const std::int64_t restated = report["restatements"];
  EXPECT_EQ(sent, turns * 5 * kRate);
  const LogReader reader = LogReader::open(log).value();
  std::int64_t dropped = 0;
  for (const LossSpan& loss : reader.losses()) {
    dropped += static_cast<std::int64_t>(loss.counts.kernel + loss.counts.queue);
  }
  // Losses are counted, including restatements.
  const auto recorded_messages = static_cast<std::int64_t>(reader.summary().messages);
  EXPECT_LE(recorded_messages, sent);
  EXPECT_GE(recorded_messages + dropped, sent);
  const double drift_us = report["drift_us"];
  std::printf(
      "sent %ld and %ld restatements, recorded %lu; late p50 %d p99 %d max %d us, drift "
      "%.1f us (%s)\n",
      sent, restated, reader.summary().messages, report["late_us"]["p50"].get<int>(),
      report["late_us"]["p99"].get<int>(), report["late_us"]["max"].get<int>(), drift_us,
      report["scheduling"].get<std::string>().c_str());
  if (isNightly()) {
    EXPECT_EQ(recorded_messages, sent);
    EXPECT_LT(std::abs(drift_us), 10'000);
  }
}

}  // namespace
}  // namespace rocinante
