#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "core/log/log_reader.h"
#include "core/net/udp_socket.h"
#include "tests/support/programs.h"
#include "tests/support/udp_queue.h"

// The real program, over real sockets on loopback.
namespace rocinante {
namespace {

using test::Program;
using test::ProgramResult;
using test::runProgram;
using test::TemporaryFolder;
using PlainJson = nlohmann::json;

/// A recording of `endpoints` (with port 0) into FOLDER/log.mcap.
struct Recording {
  explicit Recording(const std::vector<std::string>& endpoints,
                     std::vector<std::string> options = {})
      : program(start(endpoints, std::move(options))) {
    const std::string line = program.waitForLine("recording ");
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      if (word.starts_with("udp://")) bound.push_back(Endpoint::parse(word).value());
    }
  }

  Program start(std::vector<std::string> arguments, std::vector<std::string> options) {
    arguments.insert(arguments.end(), {"-o", log().string(), "--json"});
    arguments.insert(arguments.end(), options.begin(), options.end());
    return Program::start("rocinante-record", arguments);
  }

  std::filesystem::path log() const { return folder / "log.mcap"; }
  UdpSender sender(std::size_t index = 0) const {
    return std::move(UdpSender::open(bound.at(index)).value());
  }

  /// Ctrl-C; the summary.
  PlainJson finish(int exit_code = 0) {
    const ProgramResult result = program.stop();
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    return PlainJson::parse(result.out, nullptr, false);
  }

  TemporaryFolder folder;
  Program program;
  std::vector<Endpoint> bound;
};

struct Kept {
  std::string topic;
  LogTime time;
  std::string payload;
};

std::vector<Kept> captured(const std::filesystem::path& path) {
  std::vector<Kept> kept;
  auto log = LogReader::open(path);
  EXPECT_TRUE(log.ok()) << log.error().text();
  if (!log) return kept;
  for (;;) {
    const auto message = log->next();
    EXPECT_TRUE(message.ok());
    if (!message || !*message) break;
    if (!(*message)->channel->captured()) continue;
    kept.push_back({(*message)->channel->topic, (*message)->log_time,
                    std::string(textOf((*message)->payload))});
  }
  EXPECT_TRUE(log->damage().empty());
  EXPECT_TRUE(log->summary().complete);
  return kept;
}

std::uint64_t lossesIn(const std::filesystem::path& path) {
  std::uint64_t lost = 0;
  const auto log = LogReader::open(path);
  EXPECT_TRUE(log.ok());
  for (const LossSpan& each : log->losses()) {
    EXPECT_LE(each.from, each.until);
    lost += each.counts.kernel + each.counts.queue + each.counts.disk;
  }
  return lost;
}

/// Datagrams of every kind: packet text, octets, empty ones, the longest there are.
std::vector<std::string> datagrams(std::size_t count) {
  std::mt19937 random(1996);
  std::vector<std::string> made;
  made.reserve(count);
  while (made.size() < count) {
    const std::size_t i = made.size();
    if (i % 1'000 == 7) {
      made.emplace_back(65'507, static_cast<char>(random()));
    } else if (i % 100 == 5) {
      std::string noise(random() % 3'000, '\0');
      for (char& c : noise) c = static_cast<char>(random());
      made.push_back(std::move(noise));
    } else if (i % 500 == 9) {
      made.emplace_back();
    } else {
      made.push_back("RK1 arm@run " + std::to_string(i) + " 5.25\njoints arm 1 2 3 4 5 6\n");
    }
  }
  return made;
}

/// Each batch is received before the next is sent: without the right to force its buffers a socket
/// holds about 250 datagrams, and a busy machine lets a recorder wait.
void sendAll(UdpSender& sender, std::uint16_t port, const std::vector<std::string>& payloads) {
  std::vector<ByteView> views;
  for (const std::string& each : payloads) views.push_back(bytesOf(each));
  for (std::size_t begin = 0; begin < views.size(); begin += 50) {
    const auto some =
        std::span(views).subspan(begin, std::min<std::size_t>(50, views.size() - begin));
    const Status sent = sender.send(some);
    ASSERT_TRUE(sent.ok()) << sent.error().text();
    ASSERT_TRUE(test::waitUntilTaken(port));
  }
}

void expectEveryDatagram(const std::string& endpoint) {
  Recording recording({endpoint});
  ASSERT_EQ(recording.bound.size(), 1U);
  const std::vector<std::string> sent = datagrams(20'000);
  UdpSender sender = recording.sender();
  sendAll(sender, recording.bound[0].address.port, sent);
  const PlainJson summary = recording.finish();
  EXPECT_EQ(summary["packets"], sent.size());
  EXPECT_EQ(summary["losses"],
            PlainJson({{"kernel", 0}, {"queue", 0}, {"disk", 0}, {"truncated", 0}}));
  EXPECT_EQ(summary["complete"], true);
  EXPECT_EQ(summary["bytes"], std::filesystem::file_size(recording.log()));
  const std::vector<Kept> kept = captured(recording.log());
  ASSERT_EQ(kept.size(), sent.size());
  for (std::size_t i = 0; i < sent.size(); ++i) {
    ASSERT_EQ(kept[i].payload, sent[i]) << "datagram " << i;
  }
  EXPECT_EQ(LogReader::open(recording.log())->summary().origin, kept.front().time);
}

TEST(RecordProgram, KeepsEveryDatagramOverIpv4) { expectEveryDatagram("127.0.0.1:0"); }
TEST(RecordProgram, KeepsEveryDatagramOverIpv6) { expectEveryDatagram("[::1]:0"); }
TEST(RecordProgram, KeepsEveryDatagramOfAGroup) {
  expectEveryDatagram("239.255.19.96:0?interface=lo&ttl=0");
}

TEST(RecordProgram, KeepsTwoEndpointsInOneOrderOfTime) {
  Recording recording({"127.0.0.1:0", "[::1]:0"});
  ASSERT_EQ(recording.bound.size(), 2U);
  UdpSender first = recording.sender(0);
  UdpSender second = recording.sender(1);
  std::string expected;
  for (int i = 0; i < 2'000; ++i) {
    const std::string payload = std::to_string(i) + " ";
    ASSERT_TRUE((i % 3 == 0 ? first : second).send(bytesOf(payload)).ok());
    expected += payload;
    if (i % 50 != 0) continue;
    ASSERT_TRUE(test::waitUntilTaken(recording.bound[0].address.port));
    ASSERT_TRUE(test::waitUntilTaken(recording.bound[1].address.port));
  }
  const PlainJson summary = recording.finish();
  EXPECT_EQ(summary["endpoints"][0]["packets"], 667);
  EXPECT_EQ(summary["endpoints"][1]["packets"], 1'333);
  EXPECT_EQ(summary["channels"], 2);
  std::string order;
  LogTime before{};
  for (const Kept& each : captured(recording.log())) {
    EXPECT_LE(before, each.time);
    before = each.time;
    order += each.payload;
  }
  EXPECT_EQ(order, expected);
}

TEST(RecordProgram, CountsExactlyWhatTheKernelDropped) {
  Recording recording({"127.0.0.1:0"});
  UdpSender sender = recording.sender();
  // Stalled, the program cannot empty its socket.
  recording.program.signal(SIGSTOP);
  const std::string payload(1'000, 'x');
  const std::vector<ByteView> batch(100, bytesOf(payload));
  constexpr std::uint64_t kSent = 60'000;
  for (std::uint64_t sent = 0; sent < kSent; sent += batch.size()) {
    ASSERT_TRUE(sender.send(batch).ok());
  }
  recording.program.signal(SIGCONT);
  const PlainJson summary = recording.finish();
  const std::uint64_t kernel = summary["losses"]["kernel"];
  const std::uint64_t recorded = summary["packets"];
  EXPECT_GT(kernel, 0U);
  EXPECT_EQ(recorded + kernel, kSent);
  EXPECT_EQ(captured(recording.log()).size(), recorded);
  EXPECT_EQ(lossesIn(recording.log()), kernel);
}

TEST(RecordProgram, MoreLossesThanAllowedIsNo) {
  Recording recording({"127.0.0.1:0"}, {"--max-loss", "5"});
  UdpSender sender = recording.sender();
  recording.program.signal(SIGSTOP);
  const std::string payload(9'000, 'x');
  const std::vector<ByteView> batch(100, bytesOf(payload));
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(sender.send(batch).ok());
  recording.program.signal(SIGCONT);
  recording.finish(/*exit_code=*/1);
}

TEST(RecordProgram, EndsAfterExactlyMaxPackets) {
  Recording recording({"127.0.0.1:0"}, {"--max-packets", "100"});
  UdpSender sender = recording.sender();
  for (int i = 0; i < 150; ++i) {
    const std::string payload = std::to_string(i);
    ASSERT_TRUE(sender.send(bytesOf(payload)).ok());
  }
  const ProgramResult result = recording.program.finish();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(PlainJson::parse(result.out)["reason"], "packets");
  const auto kept = captured(recording.log());
  ASSERT_EQ(kept.size(), 100U);
  EXPECT_EQ(kept.back().payload, "99");
}

TEST(RecordProgram, KillsNothingWhenStoppedBySigterm) {
  Recording recording({"127.0.0.1:0"});
  UdpSender sender = recording.sender();
  ASSERT_TRUE(sender.send(bytesOf("last words")).ok());
  recording.program.signal(SIGTERM);
  EXPECT_EQ(recording.program.finish().exit_code, 0);
  EXPECT_EQ(captured(recording.log()).size(), 1U);
}

TEST(RecordProgram, ADiskThatRefusesIsNo) {
  // /dev/full can be opened but refuses every write.
  Program program =
      Program::start("rocinante-record", {"127.0.0.1:0", "-o", "/dev/full", "--force",
                                          "--compression", "none", "--duration", "2s", "--json"});
  const std::string line = program.waitForLine("rec");
  if (line.starts_with("recording ")) {
    const std::string endpoint = line.substr(10, line.find(' ', 10) - 10);
    auto sender = UdpSender::open(Endpoint::parse(endpoint).value()).value();
    for (int i = 0; i < 50; ++i) ASSERT_TRUE(sender.send(bytesOf("x")).ok());
  }
  const ProgramResult result = program.finish();
  EXPECT_NE(result.exit_code, 0);
  EXPECT_NE(result.err.find("No space left on device"), std::string::npos) << result.err;
}

TEST(RecordProgram, AccountsForADiskThatFillsUp) {
  // The inherited limit on file sizes simulates a disk that fills up.
  struct rlimit limit {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
  const struct rlimit before = limit;
  limit.rlim_cur = 200'000;
  const auto handler_before = ::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  Recording recording({"127.0.0.1:0"}, {"--compression", "none", "--sync", "10ms"});
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, handler_before);

  UdpSender sender = recording.sender();
  const std::string payload(1'000, 'x');
  const std::vector<ByteView> batch(20, bytesOf(payload));
  std::uint64_t sent = 0;
  // It ends by itself when the disk refuses, or is stopped: whichever comes first.
  for (; sent < 400; sent += batch.size()) {
    ASSERT_TRUE(sender.send(batch).ok());
    ASSERT_TRUE(test::waitUntilTaken(recording.bound[0].address.port));
  }
  const ProgramResult result = recording.program.stop();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("File too large"), std::string::npos) << result.err;
  const PlainJson summary = PlainJson::parse(result.out);
  EXPECT_EQ(summary["complete"], false);
  EXPECT_EQ(summary["reason"], "refused");
  EXPECT_GT(summary["losses"]["disk"], 0);
  EXPECT_GT(summary["packets"], 0);
  // Datagrams after the refusal are not part of the session, and are not counted.
  EXPECT_LE(
      summary["packets"].get<std::uint64_t>() + summary["losses"]["disk"].get<std::uint64_t>(),
      sent);
  auto log = LogReader::open(recording.log());
  ASSERT_TRUE(log.ok());
  std::uint64_t found = 0;
  for (auto message = log->next(); message && *message; message = log->next()) {
    if ((*message)->channel->captured()) ++found;
  }
  EXPECT_EQ(found, summary["packets"]);
}

TEST(RecordProgram, AFolderThatCannotBeWrittenIsRefusedBeforeItBegins) {
  const ProgramResult result =
      runProgram("rocinante-record", {"127.0.0.1:0", "-o", "/proc/log.mcap"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("/proc/log.mcap"), std::string::npos) << result.err;
}

TEST(RecordProgram, AnExistingLogIsReplacedOnlyByForce) {
  const TemporaryFolder folder;
  const std::string path = (folder / "log.mcap").string();
  std::ofstream(path) << "precious";
  const std::vector<std::string> arguments{"127.0.0.1:0", "-o", path, "--duration", "50ms"};
  EXPECT_EQ(runProgram("rocinante-record", arguments).exit_code, 2);
  EXPECT_EQ(std::filesystem::file_size(path), 8U);
  auto forced = arguments;
  forced.push_back("--force");
  EXPECT_EQ(runProgram("rocinante-record", forced).exit_code, 0);
  EXPECT_TRUE(captured(path).empty());
}

TEST(RecordProgram, ATakenPortLeavesNoLog) {
  const auto taken = UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value());
  ASSERT_TRUE(taken.ok());
  const TemporaryFolder folder;
  const std::string path = (folder / "log.mcap").string();
  const ProgramResult result =
      runProgram("rocinante-record", {taken->boundAddress().text(), "-o", path});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("is held by recorder_tests (pid " + std::to_string(::getpid()) +
                            "); use multicast, a relay, --tee or pcap://"),
            std::string::npos)
      << result.err;
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace rocinante
