// Ports, other hosts and a stop of the process, with the real program.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "core/net/udp_socket.h"
#include "tests/player/logs/written_log.h"
#include "tests/support/programs.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::Program;
using testing::HasSubstr;

Endpoint at(const std::string& text) { return Endpoint::parse(text).value(); }

/// A log of `count` messages, `gap` apart, from this port of 127.0.0.1.
std::filesystem::path writeSession(const std::filesystem::path& path, std::uint16_t port, int count,
                                   Nanoseconds gap) {
  auto writer = LogWriter::create(path, LogWriterOptions(), "session").value();
  const ChannelId channel =
      writer.addChannel("/udp/1/a", "octets", {{"remote", fmt::format("127.0.0.1:{}", port)}})
          .value();
  for (int i = 0; i < count; ++i) {
    const std::string payload = std::to_string(i);
    EXPECT_TRUE(writer
                    .write(channel, static_cast<std::uint32_t>(i), LogTime(1s + i * gap), 0,
                           bytesOf(payload))
                    .ok());
  }
  EXPECT_TRUE(writer.close("test").ok());
  return path;
}

/// A port that was free a moment ago.
std::uint16_t freePort() {
  return UdpReceiver::open(at("127.0.0.1:0")).value().boundAddress().port;
}

TEST(PlayNetwork, KeptPortsAreThoseOfTheOriginalSenders) {
  const test::TemporaryFolder folder;
  UdpReceiver receiver = UdpReceiver::open(at("127.0.0.1:0")).value();
  const std::string to = receiver.boundAddress().text();
  const std::uint16_t port = freePort();
  const auto log = writeSession(folder / "log", port, 5, 1ms);
  const auto played = test::runProgram(
      "rocinante-play", {log.string(), "--to", to, "--keep-ports", "--quiet", "--restate", "off"});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  std::size_t came = 0;
  for (auto batch = receiver.receive(); batch.ok() && !batch->empty(); batch = receiver.receive()) {
    for (const ReceivedDatagram& datagram : *batch) EXPECT_EQ(datagram.sender.port, port);
    came += batch->size();
  }
  EXPECT_EQ(came, 5U);

  const UdpReceiver holder = UdpReceiver::open(at(fmt::format("0.0.0.0:{}", port))).value();
  const auto refused =
      test::runProgram("rocinante-play", {log.string(), "--to", to, "--keep-ports", "--quiet"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr(fmt::format("port {}: it is held by", port)));
}

TEST(PlayNetwork, AStopOfTheProcessBecomesNoBurst) {
  const test::TemporaryFolder folder;
  const auto log = writeSession(folder / "log", 1, 60, 40ms);
  UdpReceiver receiver = UdpReceiver::open(at("127.0.0.1:0")).value();
  Program player = Program::start(
      "rocinante-play",
      {log.string(), "--to", receiver.boundAddress().text(), "--restate", "off", "--report", "-"});
  // Stopped after it has begun, with more than two seconds left.
  pollfd first{receiver.fileDescriptor(), POLLIN, 0};
  ASSERT_EQ(::poll(&first, 1, 30'000), 1);
  player.signal(SIGSTOP);
  std::this_thread::sleep_for(3s);  // length of the stop
  player.signal(SIGCONT);
  const auto result = player.finish();
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto report = nlohmann::json::parse(result.out);
  EXPECT_EQ(report["sent"], 60);
  EXPECT_GE(report["duration_s"].get<double>(), 4.5);
  // Datagrams sent to make up for the stop would be three seconds late.
  EXPECT_LT(report["late_us"]["p90"].get<double>(), 1e6);
}

/// Asks a player from another network namespace, at the other end of a veth pair: never returns.
[[noreturn]] void askFromAnotherHost(int ready, int go, int answers) {
  char told = 0;
  std::string said = "none";
  if (::unshare(CLONE_NEWNET) != 0 || ::write(ready, "n", 1) != 1 || ::read(go, &told, 1) != 1 ||
      std::system("ip address add 10.78.0.2/24 dev far && ip link set far up") != 0) {
    ::_exit(2);
  }
  std::uint16_t port = 0;
  if (::read(go, &port, sizeof port) != sizeof port) ::_exit(2);
  const int socket = ::socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(0x0A4E0001);
  ::connect(socket, reinterpret_cast<sockaddr*>(&address), sizeof address);
  for (int i = 0; i < 50 && said == "none"; ++i) {
    if (::send(socket, "status", 6, 0) < 0) continue;
    pollfd wait{socket, POLLIN, 0};
    std::array<char, 500> buffer;
    if (::poll(&wait, 1, 200) != 1) continue;
    const ssize_t size = ::recv(socket, buffer.data(), buffer.size(), 0);
    if (size > 0) said.assign(buffer.data(), static_cast<std::size_t>(size));
  }
  ::_exit(::write(answers, said.data(), said.size()) > 0 ? 0 : 2);
}

/// The answer of a player started with `options` to another host.
std::string answerToAnotherHost(const std::filesystem::path& log, std::vector<std::string> options,
                                const std::string& control = "0.0.0.0:0") {
  int ready[2], go[2], answers[2];
  if (::pipe(ready) != 0 || ::pipe(go) != 0 || ::pipe(answers) != 0) return "no pipe";
  const ::pid_t asker = ::fork();
  if (asker == 0) askFromAnotherHost(ready[1], go[0], answers[1]);
  char told = 0;
  std::string said(500, ' ');
  const bool is_wired =
      ::read(ready[0], &told, 1) == 1 &&
      std::system(fmt::format("ip link add near type veth peer name far netns {} && ip address add "
                              "10.78.0.1/24 dev near && ip link set near up && ip link set lo up",
                              asker)
                      .c_str()) == 0;
  if (is_wired && ::write(go[1], "g", 1) == 1) {
    options.insert(options.begin(),
                   {log.string(), "--to", "127.0.0.1:9", "--control", control, "--start-paused"});
    Program player = Program::start("rocinante-play", options);
    const std::string line = player.waitForLine("listening for commands on ");
    const auto port = static_cast<std::uint16_t>(std::atoi(line.c_str() + line.rfind(':') + 1));
    EXPECT_EQ(::write(go[1], &port, sizeof port), static_cast<ssize_t>(sizeof port));
    const ssize_t size = ::read(answers[0], said.data(), said.size());
    said.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
    player.stop();
  }
  ::kill(asker, SIGKILL);
  ::waitpid(asker, nullptr, 0);
  // The kernel removes our end later, and the next one has the same name.
  EXPECT_EQ(std::system("ip link delete near 2>/dev/null; "
                        "for i in $(seq 250); do ip link show near >/dev/null 2>&1 || exit 0; "
                        "sleep 0.02; done; exit 1"),
            0);
  for (const int each : {ready[0], ready[1], go[0], go[1], answers[0], answers[1]}) ::close(each);
  return said;
}

TEST(PlayNetwork, AnotherHostCommandsOnlyWhenItIsAllowedTo) {
  if (::unshare(CLONE_NEWNET) != 0) GTEST_SKIP() << "skipped: no rights for a network namespace";
  const test::TemporaryFolder folder;
  const auto log = writeSession(folder / "log", 1, 5, 1ms);
  EXPECT_EQ(answerToAnotherHost(log, {}),
            "error only this machine may control this player (see --control-allow)\n");
  EXPECT_THAT(answerToAnotherHost(log, {"--control-allow", "10.78.0.0/24"}),
              testing::StartsWith("ok t=0.000000000 state=paused"));
  EXPECT_THAT(answerToAnotherHost(log, {"--control-allow", "10.79.0.0/24"}),
              testing::StartsWith("error only this machine"));
  // An IPv6 socket receives IPv4 too, with senders such as ::ffff:10.78.0.2.
  EXPECT_THAT(answerToAnotherHost(log, {}, "[::]:0"),
              testing::StartsWith("error only this machine"));
  EXPECT_THAT(answerToAnotherHost(log, {"--control-allow", "10.78.0.0/24"}, "[::]:0"),
              testing::StartsWith("ok t=0.000000000 state=paused"));
}

}  // namespace
}  // namespace rocinante
