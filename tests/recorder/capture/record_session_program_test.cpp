#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mount.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <sstream>
#include <thread>

#include "core/log/log_reader.h"
#include "core/net/udp_socket.h"
#include "tests/support/programs.h"
#include "tests/support/udp_queue.h"

// The real program: its pieces, its ring and its conditions, over real sockets on loopback.
namespace rocinante {
namespace {

using PlainJson = nlohmann::json;
using std::chrono::milliseconds;
using test::Program;
using test::ProgramResult;
using test::TemporaryFolder;

namespace fs = std::filesystem;

class RecordingSession {
 public:
  RecordingSession(const std::string& output, std::vector<std::string> options)
      : program(start(output, std::move(options))) {
    std::istringstream words(program.waitForLine("recording "));
    std::string endpoint;
    words >> endpoint >> endpoint;
    const auto bound = Endpoint::parse(endpoint);
    EXPECT_TRUE(bound.ok()) << endpoint;
    port = bound->address.port;
    sender.emplace(std::move(UdpSender::open(*bound).value()));
  }

  static Program start(const std::string& output, std::vector<std::string> options) {
    std::vector<std::string> arguments{"127.0.0.1:0", "-o", output, "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return Program::start("rocinante-record", arguments);
  }

  void say(const std::string& payload) { ASSERT_TRUE(sender->send(bytesOf(payload)).ok()); }

  /// Sends "N padding", up to `rate_hz` a second in bursts of a millisecond, until `until` returns
  /// true. No more datagrams wait at the port than fit without the right to force its buffers.
  template <class Until>
  std::uint64_t talk(std::uint64_t rate_hz, Until until) {
    const auto start = std::chrono::steady_clock::now();
    std::uint64_t sent = 0;
    while (!until()) {
      const auto passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start);
      const auto due =
          static_cast<std::uint64_t>(passed.count() * static_cast<double>(rate_hz)) + 1;
      while (sent < due && !until()) {
        std::vector<std::string> payloads;
        std::vector<ByteView> views;
        while (sent < due && payloads.size() < 64) payloads.push_back(numbered(sent++));
        for (const std::string& each : payloads) views.push_back(bytesOf(each));
        // It may have ended by itself.
        if (!sender->send(views)) return sent;
        EXPECT_TRUE(test::waitUntilTaken(port, 150'000));
      }
      std::this_thread::sleep_for(milliseconds(1));
    }
    return sent;
  }

  PlainJson finish(int exit_code = 0) {
    const ProgramResult result = program.stop();
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    return PlainJson::parse(result.out, nullptr, false);
  }

  /// A hundred bytes that zstd can hardly compress.
  static std::string numbered(std::uint64_t number) {
    std::string payload = std::to_string(number) + " ";
    std::mt19937_64 random(number);
    while (payload.size() < 100) payload += static_cast<char>('!' + random() % 90);
    return payload;
  }

  Program program;
  std::optional<UdpSender> sender;
  std::uint16_t port = 0;
};

template <class Until>
bool waitUntil(Until until) {
  for (int i = 0; i < 15'000 && !until(); ++i) std::this_thread::sleep_for(milliseconds(2));
  return until();
}

/// Ends a talk: true when it holds, or fails the test after a minute.
template <class Holds>
auto until(Holds holds) {
  return [holds, give_up = std::chrono::steady_clock::now() + std::chrono::minutes(1)] {
    if (holds()) return true;
    if (std::chrono::steady_clock::now() < give_up) return false;
    ADD_FAILURE() << "what was waited for did not come within a minute";
    return true;
  };
}

std::vector<fs::path> logsIn(const fs::path& folder) {
  std::vector<fs::path> logs;
  for (const auto& each : fs::directory_iterator(folder)) {
    if (each.path().extension() == ".mcap") logs.push_back(each.path());
  }
  std::ranges::sort(logs);
  return logs;
}

/// The leading numbers of a log's datagrams, in order.
std::vector<std::uint64_t> numbersIn(const fs::path& path, bool complete = true) {
  std::vector<std::uint64_t> numbers;
  auto log = LogReader::open(path);
  EXPECT_TRUE(log.ok()) << log.error().text();
  if (!log) return numbers;
  EXPECT_EQ(log->summary().complete, complete) << path;
  for (auto message = log->next(); message && *message; message = log->next()) {
    if ((*message)->channel->captured()) {
      numbers.push_back(std::stoull(std::string(textOf((*message)->payload))));
    }
  }
  return numbers;
}

TEST(RecordPieces, ABlowOfSighupBeginsANewPiece) {
  const TemporaryFolder folder;
  RecordingSession recording((folder / "log.mcap").string(), {});
  recording.say("0 before");
  // Waiting datagrams belong before the seam, which comes with the next datagram.
  ASSERT_TRUE(waitUntil([&] { return fs::file_size(folder / "log.mcap") > 150; }));
  recording.program.signal(SIGHUP);
  std::uint64_t sent = 1;
  ASSERT_TRUE(waitUntil([&] {
    recording.say(std::to_string(sent++) + " after");
    return fs::exists(folder / "log-002.mcap");
  }));
  const PlainJson summary = recording.finish();
  ASSERT_EQ(summary["pieces"].size(), 2U);
  EXPECT_EQ(summary["packets"], sent);
  EXPECT_EQ(summary["log"], (folder / "log-002.mcap").string());
  std::vector<std::uint64_t> numbers = numbersIn(folder / "log.mcap");
  for (const std::uint64_t each : numbersIn(folder / "log-002.mcap")) numbers.push_back(each);
  ASSERT_EQ(numbers.size(), sent);
  EXPECT_TRUE(std::ranges::is_sorted(numbers));
}

TEST(RecordPieces, RotatingAtAHundredThousandASecondEachIsStoredOrCounted) {
  const TemporaryFolder folder;
  RecordingSession recording((folder / "p-%n.mcap").string(),
                             {"--split-size", "2MB", "--keep", "4"});
  const std::uint64_t sent =
      recording.talk(100'000, until([&] {
                       const std::vector<fs::path> logs = logsIn(folder.path());
                       return !logs.empty() && logs.back() >= folder / "p-009.mcap";
                     }));
  const PlainJson summary = recording.finish();
  const PlainJson& losses = summary["losses"];
  EXPECT_EQ(losses["disk"], 0);
  // Without other load the queue holds all datagrams that come while pieces are closed.
  if (std::getenv("ROCINANTE_NIGHTLY") != nullptr) {
    EXPECT_EQ(losses["queue"], 0);
  }
  EXPECT_EQ(summary["packets"].get<std::uint64_t>() + losses["kernel"].get<std::uint64_t>() +
                losses["queue"].get<std::uint64_t>(),
            sent);
  EXPECT_GT(summary["deleted"]["pieces"], 0) << summary;
  std::uint64_t stored = summary["deleted"]["packets"];
  const std::vector<fs::path> logs = logsIn(folder.path());
  EXPECT_EQ(logs.size(), 4U);
  std::uint64_t last = 0;
  for (const fs::path& each : logs) {
    const std::vector<std::uint64_t> numbers = numbersIn(each);
    stored += numbers.size();
    EXPECT_TRUE(std::ranges::is_sorted(numbers));
    EXPECT_LT(last, numbers.front());
    last = numbers.back();
  }
  EXPECT_EQ(stored, summary["packets"]);
}

TEST(RecordPieces, KilledWhilePiecesRotateAllButTheLastAreWhole) {
  std::random_device device;
  std::mt19937 random(device());
  for (int round = 0; round < 4; ++round) {
    const TemporaryFolder folder;
    RecordingSession recording((folder / "p-%n.mcap").string(), {"--split-size", "40kB"});
    const std::string last = fmt::format("p-{:03}.mcap", 5 + random() % 20);
    recording.talk(20'000, until([&] { return fs::exists(folder / last); }));
    recording.program.signal(SIGKILL);
    EXPECT_EQ(recording.program.finish().exit_code, 128 + SIGKILL);
    const std::vector<fs::path> logs = logsIn(folder.path());
    ASSERT_GT(logs.size(), 3U);
    std::vector<std::uint64_t> numbers;
    std::size_t incomplete = 0;
    for (const fs::path& each : logs) {
      // The last piece may have been created and be empty.
      if (each == logs.back() && fs::is_empty(each)) break;
      auto log = LogReader::open(each);
      ASSERT_TRUE(log.ok()) << log.error().text();
      const bool complete = log->summary().complete;
      incomplete += complete ? 0 : 1;
      EXPECT_FALSE(complete && incomplete > 0) << each << " was closed before an older one";
      for (const std::uint64_t number : numbersIn(each, complete)) numbers.push_back(number);
    }
    // The one being written, and those that waited for the disk to be closed.
    EXPECT_LE(incomplete, 10U);
    EXPECT_TRUE(std::ranges::is_sorted(numbers));
    EXPECT_EQ(std::set<std::uint64_t>(numbers.begin(), numbers.end()).size(), numbers.size());
  }
}

TEST(RecordPieces, ADiskThatFillsUpInALaterPieceLeavesAllWhole) {
  const TemporaryFolder folder;
  if (::mount("rocinante-test", folder.path().c_str(), "tmpfs", 0, "size=3m") != 0) {
    GTEST_SKIP() << "no file system can be mounted here";
  }
  {
    RecordingSession recording((folder / "p-%n.mcap").string(),
                               {"--split-size", "1MB", "--compression", "none"});
    // It ends by itself, and then no process has the port.
    recording.talk(20'000, until([&] { return !test::udpQueueAt(recording.port); }));
    const ProgramResult result = recording.program.stop();
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.err.find("No space left on device"), std::string::npos) << result.err;
    const PlainJson summary = PlainJson::parse(result.out, nullptr, false);
    EXPECT_EQ(summary["reason"], "refused");
    EXPECT_GT(summary["losses"]["disk"], 0);
    EXPECT_GE(summary["pieces"].size(), 2U);
    std::uint64_t stored = 0;
    std::uint64_t told = 0;
    for (const fs::path& each : logsIn(folder.path())) {
      stored += numbersIn(each).size();
      const auto log = LogReader::open(each);
      for (const LossSpan& loss : log->losses()) told += loss.counts.disk;
    }
    EXPECT_EQ(stored, summary["packets"]);
    EXPECT_EQ(told, summary["losses"]["disk"]);
  }
  ::umount2(folder.path().c_str(), MNT_DETACH);
}

TEST(RecordRing, ASignalWritesWhatIsHeld) {
  const TemporaryFolder folder;
  RecordingSession recording((folder / "ring-%n.mcap").string(),
                             {"--ring", "60s", "--keep", "1", "--status", "50ms"});
  for (int i = 0; i < 200; ++i) recording.say(std::to_string(i) + " x");
  recording.program.waitForLine(" 200 packets ");
  EXPECT_TRUE(logsIn(folder.path()).empty());
  recording.program.signal(SIGUSR1);
  recording.program.waitForLine("ring-001.mcap is written");
  EXPECT_EQ(numbersIn(folder / "ring-001.mcap").size(), 200U);
  recording.say("200 x");
  recording.program.waitForLine(" 201 packets ");
  recording.program.signal(SIGUSR1);
  recording.program.waitForLine("ring-001.mcap is deleted");
  const PlainJson summary = recording.finish();
  EXPECT_EQ(numbersIn(folder / "ring-002.mcap").size(), 201U);
  EXPECT_EQ(logsIn(folder.path()).size(), 1U);
  EXPECT_EQ(summary["packets"], 201);
  EXPECT_EQ(summary["pieces"][0]["why"], "signal");
  EXPECT_EQ(summary["pieces"][0]["cut_short"], false);
}

TEST(RecordRing, WithoutASignalNothingIsWritten) {
  const TemporaryFolder folder;
  RecordingSession recording((folder / "ring.mcap").string(), {"--ring", "1s"});
  recording.say("0 x");
  const PlainJson summary = recording.finish();
  EXPECT_TRUE(fs::is_empty(folder.path()));
  EXPECT_TRUE(summary["log"].is_null());
  EXPECT_TRUE(summary["pieces"].empty());
}

TEST(RecordConditions, BeginAndEndWithTheDatagramsThatMeetThem) {
  const TemporaryFolder folder;
  RecordingSession recording((folder / "log.mcap").string(),
                             {"--start-on", "event=cycle begins", "--stop-on", "cycle ends"});
  EXPECT_FALSE(recording.program.waitForLine("waiting for event=cycle begins").empty());
  recording.say("RK1 arm@r 0 -\nadd arm puma\n");
  recording.say("RK1 arm@r 1 -\nevent \"cycle ends\"\n");
  recording.say("RK1 arm@r 2 -\nevent \"cycle begins\"\n");
  recording.say("RK1 arm@r 3 -\njoints arm 1\n");
  recording.say("RK1 arm@r 4 -\nevent \"cycle ends\"\n");
  recording.say("RK1 arm@r 5 -\njoints arm 2\n");
  const ProgramResult result = recording.program.finish();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const PlainJson summary = PlainJson::parse(result.out, nullptr, false);
  EXPECT_EQ(summary["packets"], 3);
  EXPECT_EQ(summary["packets_before"], 2);
  EXPECT_EQ(summary["reason"], "condition");
  auto log = LogReader::open(folder / "log.mcap").value();
  EXPECT_EQ(log.summary().messages, 3U);
  EXPECT_EQ(log.summary().end_reason, "condition");
}

TEST(RecordConditions, ASilenceEndsIt) {
  const TemporaryFolder folder;
  RecordingSession recording((folder / "log.mcap").string(), {"--stop-on", "silence=200ms"});
  recording.say("0 x");
  const ProgramResult result = recording.program.finish();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(PlainJson::parse(result.out)["reason"], "condition");
  EXPECT_EQ(numbersIn(folder / "log.mcap").size(), 1U);
}

TEST(RecordConditions, TheDurationCountsFromTheBeginning) {
  const TemporaryFolder folder;
  RecordingSession recording((folder / "log.mcap").string(),
                             {"--start-on", "source=arm", "--duration", "300ms"});
  // Longer than the duration, before anything begins.
  std::this_thread::sleep_for(milliseconds(500));
  recording.say("RK1 arm - -\n");
  const ProgramResult result = recording.program.finish();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(PlainJson::parse(result.out)["reason"], "duration");
  EXPECT_EQ(PlainJson::parse(result.out)["packets"], 1);
}

}  // namespace
}  // namespace rocinante
