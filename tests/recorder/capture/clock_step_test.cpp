#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/log/log_reader.h"
#include "core/net/udp_socket.h"
#include "tests/support/programs.h"
#include "tests/support/udp_queue.h"

// The real program, whose wall clock is set while it records (clock_shim.cpp).
namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::Program;
using test::TemporaryFolder;

/// A recorder whose wall clock can be set, and its sender.
class SettableRecorder {
 public:
  explicit SettableRecorder(std::vector<std::string> options) {
    const std::string clock = (folder_ / "clock").string();
    file_ = ::open(clock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    EXPECT_EQ(::ftruncate(file_, sizeof(std::int64_t)), 0);
    memory_ = ::mmap(nullptr, sizeof(std::int64_t), PROT_READ | PROT_WRITE, MAP_SHARED, file_, 0);
    EXPECT_NE(memory_, MAP_FAILED);
    ::setenv("ROCINANTE_TEST_CLOCK", clock.c_str(), 1);
    ::setenv("LD_PRELOAD", ROCINANTE_CLOCK_SHIM, 1);
    // A sanitizer runtime must be loaded first; it does not need the preload.
    ::setenv("ASAN_OPTIONS", "verify_asan_link_order=0", 0);
    options.insert(options.begin(), {"127.0.0.1:0", "--json"});
    program_.emplace(Program::start("rocinante-record", options));
    ::unsetenv("LD_PRELOAD");
    const std::string line = program_->waitForLine("recording ");
    const std::string endpoint = line.substr(10, line.find(' ', 10) - 10);
    const Endpoint bound = Endpoint::parse(endpoint).value();
    port_ = bound.address.port;
    sender_.emplace(UdpSender::open(bound).value());
  }
  ~SettableRecorder() {
    ::munmap(memory_, sizeof(std::int64_t));
    ::close(file_);
  }
  SettableRecorder(const SettableRecorder&) = delete;
  SettableRecorder& operator=(const SettableRecorder&) = delete;

  void set(Nanoseconds by) {
    auto* const offset = static_cast<volatile std::int64_t*>(memory_);
    *offset = *offset + by.count();
  }
  /// Returns when the recorder has received it.
  void send() {
    for (int i = 0; i < 40; ++i) {
      ASSERT_TRUE(sender_->send(bytesOf("x")).ok());
      ::usleep(2'000);
    }
    ASSERT_TRUE(test::waitUntilTaken(port_));
  }
  Program& program() { return *program_; }

 private:
  TemporaryFolder folder_;
  int file_ = -1;
  void* memory_ = MAP_FAILED;
  std::uint16_t port_ = 0;
  std::optional<Program> program_;
  std::optional<UdpSender> sender_;
};

/// Number of clock steps in a log that is being recorded.
std::size_t stepsIn(const std::filesystem::path& path) {
  std::size_t told = 0;
  auto log = LogReader::open(path);
  if (!log) return told;
  for (auto message = log->next(); message && *message; message = log->next()) {
    told += (*message)->channel->topic == "/rocinante/clock" ? 1 : 0;
  }
  return told;
}

TEST(ClockStep, SettingTheClockBendsNothingAndIsTold) {
  const TemporaryFolder folder;
  SettableRecorder recorder({"-o", (folder / "log.mcap").string()});
  const auto before = std::chrono::steady_clock::now();
  recorder.send();
  std::size_t set_so_far = 0;
  for (const Nanoseconds set : {Nanoseconds(1h), Nanoseconds(-24h)}) {
    recorder.set(set);
    recorder.send();
    ++set_so_far;
    // Before the clock is set again.
    const auto give_up = std::chrono::steady_clock::now() + 30s;
    while (stepsIn(folder / "log.mcap") < set_so_far &&
           std::chrono::steady_clock::now() < give_up) {
      ::usleep(10'000);
    }
  }
  const auto took = std::chrono::steady_clock::now() - before;
  const auto result = recorder.program().stop();
  ASSERT_EQ(result.exit_code, 0) << result.err;

  auto log = LogReader::open(folder / "log.mcap");
  ASSERT_TRUE(log.ok()) << log.error().text();
  std::vector<LogTime> times;
  std::vector<std::int64_t> steps;
  for (auto message = log->next(); message && *message; message = log->next()) {
    if ((*message)->channel->topic == "/rocinante/clock") {
      const auto json = nlohmann::json::parse(textOf((*message)->payload));
      steps.push_back(json["step_ns"].get<std::int64_t>());
    } else if ((*message)->channel->captured()) {
      times.push_back((*message)->log_time);
    }
  }
  ASSERT_EQ(times.size(), 120U);
  for (std::size_t i = 1; i < times.size(); ++i) EXPECT_LE(times[i - 1], times[i]);
  // The duration is the real one: neither an hour more nor a day less.
  EXPECT_GE(times.back() - times.front(), Nanoseconds(200ms));
  EXPECT_LE(times.back() - times.front(), took + 100ms);
  ASSERT_EQ(steps.size(), 2U);
  const auto second = static_cast<double>(Nanoseconds(1s).count());
  EXPECT_NEAR(static_cast<double>(steps[0]), static_cast<double>(Nanoseconds(1h).count()), second);
  EXPECT_NEAR(static_cast<double>(steps[1]), static_cast<double>(Nanoseconds(-24h).count()),
              second);
}

TEST(ClockStep, NeitherPiecesNorARingNorSilenceGoByTheWallClock) {
  const TemporaryFolder folder;
  const std::vector<std::vector<std::string>> ways{
      {"-o", (folder / "piece-%n.mcap").string(), "--split-time", "50ms"},
      {"-o", (folder / "ring-%n.mcap").string(), "--ring", "1h", "--ring-after", "1h"},
      // A clock set an hour ahead is not half an hour of silence.
      {"-o", (folder / "log.mcap").string(), "--stop-on", "silence=30m"}};
  for (const std::vector<std::string>& way : ways) {
    SCOPED_TRACE(way[1]);
    const bool ring = way[2] == "--ring";
    SettableRecorder recorder(way);
    recorder.send();
    for (const Nanoseconds set : {Nanoseconds(1h), Nanoseconds(-24h), Nanoseconds(24h * 365)}) {
      recorder.set(set);
      recorder.send();
    }
    if (ring) {
      recorder.program().signal(SIGUSR1);
      recorder.program().waitForLine("signal: ");
    }
    const auto result = recorder.program().stop();
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto summary = nlohmann::json::parse(result.out);
    EXPECT_EQ(summary["reason"], "interrupted");
    EXPECT_EQ(summary["losses"]["queue"], 0);
    std::uint64_t packets = 0;
    std::string reached;
    for (const auto& piece : summary["pieces"]) {
      packets += piece["packets"].get<std::uint64_t>();
      EXPECT_LT(reached, piece["start"].get<std::string>());
      reached = piece["end"].get<std::string>();
    }
    EXPECT_EQ(packets, 160U);
    EXPECT_EQ(summary["pieces"].size() > 1, way[2] == "--split-time");
  }
}

}  // namespace
}  // namespace rocinante
