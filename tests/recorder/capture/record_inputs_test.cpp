#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/log/log_reader.h"
#include "core/net/udp_socket.h"
#include "tests/core/subscription/loopback_relay.h"
#include "tests/support/network_namespace.h"
#include "tests/support/programs.h"
#include "tests/support/udp_queue.h"

// What the real program receives, refuses and forwards, over real sockets.
namespace rocinante {
namespace {

using test::NetworkNamespace;
using test::Program;
using test::ProgramResult;
using test::TemporaryFolder;
using ::testing::HasSubstr;
using PlainJson = nlohmann::json;

struct RecordingInputs {
  explicit RecordingInputs(std::vector<std::string> arguments,
                           const std::string& said = "recording ")
      : program(start(std::move(arguments))) {
    const std::string line = program.waitForLine(said);
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      if (word.starts_with("udp://")) bound.push_back(Endpoint::parse(word).value());
    }
  }
  Program start(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"-o", (folder / "log.mcap").string(), "--json"});
    return Program::start("rocinante-record", arguments);
  }
  UdpSender sender() const { return std::move(UdpSender::open(bound.at(0)).value()); }
  PlainJson finish() {
    result = program.stop();
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return PlainJson::parse(result.out, nullptr, false);
  }
  std::vector<std::string> payloads() const {
    std::vector<std::string> all;
    auto log = LogReader::open(folder / "log.mcap");
    EXPECT_TRUE(log.ok());
    for (auto message = log->next(); message && *message; message = log->next()) {
      if ((*message)->channel->captured()) all.emplace_back(textOf((*message)->payload));
    }
    return all;
  }

  TemporaryFolder folder;
  Program program;
  ProgramResult result;
  std::vector<Endpoint> bound;
};

UdpSender senderFrom(std::string_view host, Endpoint to) {
  // Only a group's endpoint names a source; a unicast sender is bound by its destination.
  to.address.address = SocketAddress::parse(host, 0).value().address;
  return std::move(UdpSender::open(to).value());
}

TEST(RecordInputs, RecordsOnlyWhomAllowNames) {
  // To 127.0.0.2 the system sends from 127.0.0.1; to itself, from itself.
  RecordingInputs recording({":0", "[::]:0", "--allow", "127.0.0.0/31", "--allow", "fd00::/8"});
  ASSERT_EQ(recording.bound.size(), 2U);
  UdpSender near = senderFrom("127.0.0.1", recording.bound[0]);
  UdpSender other = senderFrom("::1", recording.bound[1]);
  for (int i = 0; i < 10; ++i) {
    ASSERT_TRUE(near.send(bytesOf("kept")).ok());
    ASSERT_TRUE(other.send(bytesOf("refused")).ok());
  }
  const PlainJson summary = recording.finish();
  EXPECT_EQ(summary["packets"], 10);
  EXPECT_EQ(summary["endpoints"][0]["refused"], 0);
  EXPECT_EQ(summary["endpoints"][1]["refused"], 10);
  EXPECT_EQ(summary["losses"]["kernel"], 0);
  EXPECT_EQ(recording.payloads(), std::vector<std::string>(10, "kept"));
}

TEST(RecordInputs, ARelayThatNeverAnswersIsAnErrorAtTheEnd) {
  test::LoopbackRelay relay;
  relay.setAway(true);
  const TemporaryFolder folder;
  Program recorder =
      Program::start("rocinante-record", {relay.endpoint(), "--quiet", "--json", "--duration",
                                          "50ms", "-o", (folder / "log.mcap").string()});
  const ProgramResult result = recorder.finish();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.err, "rocinante-record: " + relay.endpoint() + ": never answered\n");
  const PlainJson summary = PlainJson::parse(result.out);
  EXPECT_EQ(summary["first_after_s"], nullptr);
  EXPECT_EQ(summary["endpoints"][0]["subscription"],
            (PlainJson{{"accepted_after_s", nullptr}, {"trouble", "never answered"}}));
}

TEST(RecordInputs, ARelayThatComesLaterIsAcceptedAndTimed) {
  test::LoopbackRelay relay;
  relay.setAway(true);
  RecordingInputs recording({relay.endpoint()});
  relay.setAway(false);
  recording.program.waitForLine("subscribed to relay hall at " + relay.endpoint());
  ASSERT_TRUE(relay.send("RK1 arm 1 -\njoints arm 1\n"));
  ASSERT_TRUE(test::waitUntilTaken(relay.subscriber().port));
  const PlainJson summary = recording.finish();
  const PlainJson& subscription = summary["endpoints"][0]["subscription"];
  EXPECT_GT(subscription["accepted_after_s"].get<double>(), 0);
  EXPECT_EQ(subscription["trouble"], nullptr);
  EXPECT_GT(summary["first_after_s"].get<double>(), 0);
}

TEST(RecordInputs, RecordsWhatARelaySends) {
  test::LoopbackRelay relay;
  RecordingInputs recording({relay.endpoint(), "127.0.0.1:0"});
  recording.program.waitForLine("subscribed to relay hall at " + relay.endpoint());
  // As long as it takes the lease to be kept under constant traffic.
  int sent = 0;
  bool kept = false;
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!kept && std::chrono::steady_clock::now() < give_up) {
    const bool is_sent = relay.send("RK1 arm " + std::to_string(sent) + " -\njoints arm 1\n");
    sent += is_sent ? 1 : 0;
    relay.with([&](const test::FakeRelay& each) { kept = each.kept > 0; });
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_TRUE(kept);
  ASSERT_TRUE(relay.send("RK1 arm 5 - by=hall restated part=g:1/1\njoints arm 1\n"));
  ASSERT_TRUE(relay.send("last"));
  ASSERT_TRUE(recording.sender().send(bytesOf("RKS1 leave id=0000000000000000\n")).ok());
  ASSERT_TRUE(recording.sender().send(bytesOf("direct")).ok());
  for (const std::uint16_t port : {relay.subscriber().port, recording.bound.at(0).address.port}) {
    ASSERT_TRUE(test::waitUntilTaken(port));
  }
  const PlainJson status = recording.finish();
  EXPECT_EQ(status["packets"], sent + 3);
  EXPECT_EQ(status["endpoints"][0]["endpoint"], relay.endpoint());
  EXPECT_EQ(status["endpoints"][0]["requests"], 0);
  EXPECT_EQ(status["endpoints"][0]["strangers"], 0);
  EXPECT_EQ(status["endpoints"][1]["requests"], 1);
  EXPECT_TRUE(relay.waitUntil([](const test::FakeRelay& each) { return each.left == 1; }));

  std::map<std::string, int> by_topic;
  auto log = LogReader::open(recording.folder / "log.mcap");
  ASSERT_TRUE(log.ok());
  for (auto message = log->next(); message && *message; message = log->next()) {
    ++by_topic[(*message)->channel->topic];
    EXPECT_EQ(textOf((*message)->payload).find("RKS1"), std::string_view::npos);
  }
  const std::string root = "/subscribe/" + relay.address().text();
  EXPECT_EQ(by_topic[root + "/arm"], sent);
  EXPECT_EQ(by_topic[root + "/127.0.0.1"], 1);
  EXPECT_EQ(by_topic["/rocinante/restated" + root + "/arm"], 1);

  // It replays like any other.
  auto receiver = UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value());
  ASSERT_TRUE(receiver.ok());
  auto play = Program::start("rocinante-play",
                             {(recording.folder / "log.mcap").string(), "--to",
                              receiver->boundAddress().text(), "--asap", "--channel", root + "/*"});
  EXPECT_EQ(play.finish().exit_code, 0);
  std::vector<std::string> played;
  for (auto batch = receiver->receive(); batch && !batch->empty(); batch = receiver->receive()) {
    for (const ReceivedDatagram& each : *batch) played.emplace_back(textOf(each.payload));
  }
  EXPECT_THAT(played, testing::Contains("last"));
}

TEST(RecordInputs, SendsOnEverythingVerbatim) {
  auto receiver = UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value()).value();
  RecordingInputs recording({"127.0.0.1:0", "--tee", receiver.boundAddress().text()});
  UdpSender sender = recording.sender();
  std::vector<std::string> sent{"", std::string(65'507, 'x')};
  for (int i = 0; i < 200; ++i) sent.push_back(std::to_string(i));
  for (const std::string& each : sent) ASSERT_TRUE(sender.send(bytesOf(each)).ok());
  std::vector<std::string> teed;
  while (teed.size() < sent.size()) {
    pollfd readable{receiver.fileDescriptor(), POLLIN, 0};
    if (::poll(&readable, 1, 5'000) <= 0) break;
    const auto batch = receiver.receive();
    ASSERT_TRUE(batch.ok());
    for (const ReceivedDatagram& each : *batch) teed.emplace_back(textOf(each.payload));
  }
  EXPECT_EQ(teed, sent);
  const PlainJson summary = recording.finish();
  EXPECT_EQ(summary["packets"], sent.size());
  EXPECT_EQ(summary["tees"][0]["sent"], sent.size());
  EXPECT_EQ(summary["tees"][0]["dropped"], 0);
  EXPECT_EQ(recording.payloads(), sent);
}

TEST(RecordInputs, ATeeToItselfIsRefused) {
  const TemporaryFolder folder;
  auto free_port = UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value());
  const std::string port = std::to_string(free_port->boundAddress().port);
  free_port = Error{ErrorKind::refused, "closed", ""};
  const ProgramResult result = test::runProgram(
      "rocinante-record",
      {":" + port, "--tee", "127.0.0.1:" + port, "-o", (folder / "log.mcap").string()});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("it would receive itself endlessly"));
  EXPECT_FALSE(std::filesystem::exists(folder / "log.mcap"));
}

TEST(RecordInputs, WatchesWhatHasItsReceiverAndNotItsOwnTee) {
  const NetworkNamespace network;
  ROCINANTE_NEEDS_NETWORK_NAMESPACE(network);
  auto receiver = UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value()).value();
  auto teed = UdpReceiver::open(Endpoint::parse("[::1]:0").value()).value();
  RecordingInputs recording({"pcap://lo", "--tee", teed.boundAddress().text()});
  Endpoint to = receiver.endpoint();
  to.address = receiver.boundAddress();
  auto sender = UdpSender::open(to).value();
  std::vector<std::string> sent;
  for (int i = 0; i < 300; ++i) {
    sent.push_back("RK1 arm " + std::to_string(i) + " -\njoints arm 1\n");
    ASSERT_TRUE(sender.send(bytesOf(sent.back())).ok());
  }
  // Stopped at once: datagrams still in the kernel are recorded too.
  const PlainJson summary = recording.finish();
  EXPECT_EQ(summary["packets"], 300);
  EXPECT_EQ(summary["tees"][0]["sent"], 300);
  EXPECT_EQ(recording.payloads(), sent);
  const auto log = LogReader::open(recording.folder / "log.mcap");
  ASSERT_TRUE(log.ok());
  for (const LogChannel& channel : log->channels()) {
    if (!channel.captured()) continue;
    EXPECT_EQ(channel.topic, "/udp/" + std::to_string(to.address.port) + "/arm");
    EXPECT_EQ(channel.metadata.at("local"), to.address.text());
    EXPECT_EQ(channel.metadata.at("remote"), sender.localAddress().text());
    EXPECT_EQ(channel.metadata.at("interface"), "lo");
  }
}

TEST(RecordInputs, GoesOnWhenAnInterfaceIsMadeAnew) {
  const NetworkNamespace network;
  ROCINANTE_NEEDS_NETWORK_NAMESPACE(network);
  const std::string make =
      "ip link add cell0 type veth peer name robot0 && ip addr add 10.9.0.1/24 dev cell0 && "
      "ip link set robot0 up && ip link set cell0 up";
  ASSERT_TRUE(NetworkNamespace::run(make));
  RecordingInputs recording({"239.1.2.3:5000?interface=cell0", "127.0.0.1:0"});
  const auto send = [&](const std::string& word) {
    const auto sender = UdpSender::open(Endpoint::parse("239.1.2.3:5000?interface=cell0").value());
    if (sender) (void)const_cast<UdpSender&>(*sender).send(bytesOf(word));
  };
  UdpSender other = std::move(UdpSender::open(recording.bound[1]).value());
  send("before");
  ASSERT_TRUE(NetworkNamespace::run("ip link del cell0"));
  recording.program.waitForLine("; nothing is received until it returns");
  ASSERT_TRUE(other.send(bytesOf("meanwhile")).ok());
  ASSERT_TRUE(NetworkNamespace::run(make));
  recording.program.waitForLine("joined udp://239.1.2.3:5000?interface=cell0 again");
  // An interface that comes up needs a moment before it has a carrier.
  for (int i = 0; i < 20; ++i) {
    send("after");
    ::poll(nullptr, 0, 10);
  }
  recording.finish();
  const auto payloads = recording.payloads();
  EXPECT_THAT(payloads, testing::Contains("before"));
  EXPECT_THAT(payloads, testing::Contains("meanwhile"));
  EXPECT_THAT(payloads, testing::Contains("after"));
}

TEST(RecordInputs, WaitsForAnInterfaceThatIsMadeLater) {
  const NetworkNamespace network;
  ROCINANTE_NEEDS_NETWORK_NAMESPACE(network);
  const std::string group = "udp://239.1.2.3:5000?interface=late0";
  const TemporaryFolder folder;
  auto program = Program::start(
      "rocinante-record", {group, "--wait-interface", "60s", "-o", "log.mcap"}, folder.path());
  program.waitForLine("waiting for the network interface late0");
  EXPECT_FALSE(std::filesystem::exists(folder / "log.mcap")) << "nothing is bound or made yet";
  ASSERT_TRUE(
      NetworkNamespace::run("ip link add late0 type veth peer name robot0 && "
                            "ip addr add 10.9.0.1/24 dev late0 && ip link set robot0 up && "
                            "ip link set late0 up"));
  program.waitForLine("recording " + group);
  auto sender = UdpSender::open(Endpoint::parse(group).value());
  ASSERT_TRUE(sender.ok()) << sender.error().text();
  for (int i = 0; i < 20; ++i) {
    (void)sender->send(bytesOf(std::string_view("heard")));
    ::poll(nullptr, 0, 10);
  }
  const ProgramResult result = program.stop();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out + result.err, HasSubstr(" packets on 1 channel in "));
  EXPECT_THAT(result.out + result.err, testing::Not(HasSubstr("recorded 0 packets")));
}

TEST(RecordInputs, GivesUpWaitingForAnInterfaceWithWhatThereIs) {
  const ProgramResult late = test::runProgram(
      "rocinante-record", {"udp://239.1.2.3:5000?interface=no-such-9", "--wait-interface", "50ms"});
  EXPECT_EQ(late.exit_code, 2);
  EXPECT_THAT(late.err,
              HasSubstr("the network interface did not appear within 0.05 s; there are "));
  auto program = Program::start(
      "rocinante-record", {"udp://239.1.2.3:5000?interface=no-such-9", "--wait-interface", "60s"});
  program.waitForLine("waiting for the network interface no-such-9");
  const ProgramResult stopped = program.stop();
  EXPECT_EQ(stopped.exit_code, 2);
  EXPECT_THAT(stopped.err, HasSubstr("interrupted while waiting for a network interface"));
}

TEST(RecordInputs, SaysWhatIsNeededToCapture) {
  if (::geteuid() != 0) GTEST_SKIP() << "needs root, to give it up";
  // What root starts without this capability may not capture either.
  constexpr int kNetRaw = 13;
  const pid_t pid = ::fork();
  ASSERT_GE(pid, 0);
  if (pid == 0) {
    ::prctl(PR_CAPBSET_DROP, kNetRaw);
    const std::string program = std::string(ROCINANTE_BIN_DIR) + "/rocinante-record";
    ::_exit(std::system((program + " pcap://lo -o none.mcap 2>&1 | grep -q 'CAP_NET_RAW: run it as "
                                   "root, or once: sudo setcap cap_net_raw+ep /'")
                            .c_str()) == 0
                ? 0
                : 1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(pid, &status, 0), pid);
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace rocinante
