#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "core/log/log_reader.h"
#include "core/net/udp_socket.h"
#include "tests/support/programs.h"
#include "tests/support/udp_queue.h"

// The true program, whose wall clock is set while it records (clock_shim.cpp).
namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::Program;
using test::TemporaryFolder;

TEST(ClockStep, SettingTheClockBendsNothingAndIsTold) {
  const TemporaryFolder folder;
  const std::string clock = (folder / "clock").string();
  const int file = ::open(clock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  ASSERT_EQ(::ftruncate(file, sizeof(std::int64_t)), 0);
  void* memory = ::mmap(nullptr, sizeof(std::int64_t), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  ASSERT_NE(memory, MAP_FAILED);
  auto* const offset = static_cast<volatile std::int64_t*>(memory);

  ::setenv("ROCINANTE_TEST_CLOCK", clock.c_str(), 1);
  ::setenv("LD_PRELOAD", ROCINANTE_CLOCK_SHIM, 1);
  // A sanitizer wants to be loaded first, and can do without.
  ::setenv("ASAN_OPTIONS", "verify_asan_link_order=0", 0);
  Program program = Program::start("rocinante-record",
                                   {"127.0.0.1:0", "-o", (folder / "log.mcap").string(), "--json"});
  ::unsetenv("LD_PRELOAD");
  const std::string line = program.waitForLine("recording ");
  const std::string endpoint = line.substr(10, line.find(' ', 10) - 10);
  const Endpoint bound = Endpoint::parse(endpoint).value();
  auto sender = UdpSender::open(bound).value();

  const auto before = std::chrono::steady_clock::now();
  const auto send = [&] {
    for (int i = 0; i < 40; ++i) {
      ASSERT_TRUE(sender.send(bytesOf("x")).ok());
      ::usleep(2'000);
    }
  };
  // How many steps of the clock stand in the log by now.
  const auto stepsTold = [&] {
    std::size_t told = 0;
    auto log = LogReader::open(folder / "log.mcap");
    if (!log) return told;
    for (auto message = log->next(); message && *message; message = log->next()) {
      told += (*message)->channel->topic == "/rocinante/clock" ? 1 : 0;
    }
    return told;
  };
  send();
  ASSERT_TRUE(test::waitUntilTaken(bound.address.port));
  std::size_t set_so_far = 0;
  for (const Nanoseconds set : {Nanoseconds(1h), Nanoseconds(-24h)}) {
    *offset = *offset + set.count();
    send();
    // Before the clock is set again.
    const auto give_up = std::chrono::steady_clock::now() + 30s;
    ++set_so_far;
    while (stepsTold() < set_so_far && std::chrono::steady_clock::now() < give_up) ::usleep(10'000);
  }
  const auto took = std::chrono::steady_clock::now() - before;
  const auto result = program.stop();
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
  // As long as it truly took: neither an hour more nor a day less.
  EXPECT_GE(times.back() - times.front(), Nanoseconds(200ms));
  EXPECT_LE(times.back() - times.front(), took + 100ms);
  ASSERT_EQ(steps.size(), 2U);
  const auto second = static_cast<double>(Nanoseconds(1s).count());
  EXPECT_NEAR(static_cast<double>(steps[0]), static_cast<double>(Nanoseconds(1h).count()), second);
  EXPECT_NEAR(static_cast<double>(steps[1]), static_cast<double>(Nanoseconds(-24h).count()),
              second);
  ::munmap(memory, sizeof(std::int64_t));
  ::close(file);
}

}  // namespace
}  // namespace rocinante
