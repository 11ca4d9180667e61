#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <sstream>

#include "core/net/udp_socket.h"
#include "tests/core/subscription/loopback_relay.h"
#include "tests/support/network_namespace.h"
#include "tests/support/programs.h"
#include "tests/support/udp_queue.h"

namespace rocinante {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::string_view kProgramArm =
    "<robot name=\"arm\"> <link name=\"base\"/> <link name=\"hand\"/> <joint name=\"turn\" "
    "type=\"continuous\"> <parent link=\"base\"/> <child link=\"hand\"/> </joint> </robot>";

/// The program, listening, with a packet on its way to it.
class LiveCheck {
 public:
  LiveCheck(const std::string& duration, std::string_view packet) {
    std::ofstream(folder_ / "arm.urdf") << kProgramArm;
    check_.emplace(test::Program::start(
        "rocinante-check", {"arm.urdf", "--live", "127.0.0.1:0", "--duration", duration},
        folder_.path()));
    const std::string said = check_->waitForLine("listening on ");
    const Result<Endpoint> to = Endpoint::parse(said.substr(said.find("udp://")));
    EXPECT_TRUE(to.ok()) << said;
    port_ = to->address.port;
    Result<UdpSender> sender = UdpSender::open(*to);
    EXPECT_TRUE(sender.ok());
    EXPECT_TRUE(sender->send(bytesOf(packet)).ok());
  }
  test::Program& program() { return *check_; }
  std::uint16_t port() const { return port_; }

 private:
  const test::TemporaryFolder folder_;
  std::optional<test::Program> check_;
  std::uint16_t port_ = 0;
};

TEST(CheckProgram, JudgesWhatArrivesForAWhile) {
  // All listen at once: each for long enough that a busy machine delivers its packet.
  LiveCheck fits("3s", "RK1 me@a - -\njoints arm 1\n");
  LiveCheck differs("3s", "RK1 me@a - -\njoints arm 1 2\n");
  LiveCheck unknown("3s", "hello");

  const test::ProgramResult yes = fits.program().finish();
  EXPECT_EQ(yes.exit_code, 0) << yes.out << yes.err;
  EXPECT_THAT(yes.out, HasSubstr("1 packet of 1 source"));
  EXPECT_TRUE(yes.out.ends_with("\ncompatible\n")) << yes.out;

  const test::ProgramResult no = differs.program().finish();
  EXPECT_EQ(no.exit_code, 1);
  EXPECT_THAT(no.out, HasSubstr("[packet.joint-count]"));

  const test::ProgramResult nothing = unknown.program().finish();
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_TRUE(nothing.out.ends_with("nothing judged: no packet could be decoded\n")) << nothing.out;
}

/// The program, listening on several ports or at relays.
class ManyLive {
 public:
  ManyLive(const std::vector<std::string>& endpoints, const std::string& duration) {
    std::ofstream(folder_ / "arm.urdf") << kProgramArm;
    std::vector<std::string> arguments{"arm.urdf", "--duration", duration};
    for (const std::string& each : endpoints) arguments.insert(arguments.end(), {"--live", each});
    program.emplace(test::Program::start("rocinante-check", arguments, folder_.path()));
    std::istringstream words(program->waitForLine("listening on "));
    for (std::string word; words >> word;) {
      if (word.starts_with("udp://"))
        senders.push_back(UdpSender::open(Endpoint::parse(word).value()).value());
      if (word.find("://") != word.npos) bound.push_back(word);
    }
  }

  std::optional<test::Program> program;
  std::vector<UdpSender> senders;
  std::vector<std::string> bound;

 private:
  const test::TemporaryFolder folder_;
};

TEST(CheckProgram, JudgesSeveralEndpointsTogether) {
  ManyLive live({"127.0.0.1:0", "127.0.0.1:0", "127.0.0.1:0"}, "3s");
  ASSERT_EQ(live.senders.size(), 3U);
  // One source by two paths, each of which lost what the other brought, and another by one of them.
  for (int i = 10; i < 30; ++i) {
    const std::string packet = "RK1 me@a " + std::to_string(i) + " -\njoints arm 1\n";
    EXPECT_TRUE(i == 15 || live.senders[0].send(bytesOf(packet)).ok());
    EXPECT_TRUE(i == 20 || live.senders[1].send(bytesOf(packet)).ok());
  }
  ASSERT_TRUE(live.senders[1].send(bytesOf("RK1 you@a 1 -\njoints arm 1 2\n")).ok());
  const test::ProgramResult judged = live.program->finish();
  EXPECT_EQ(judged.exit_code, 1) << judged.out << judged.err;
  EXPECT_THAT(judged.out, HasSubstr("39 packets of 2 sources"));
  EXPECT_THAT(judged.out, HasSubstr("[packet.joint-count]"));
  EXPECT_THAT(judged.out, HasSubstr("[source.duplicate]"));
  EXPECT_THAT(judged.out, Not(HasSubstr("[source.gap]")));
  EXPECT_THAT(judged.out, HasSubstr(live.bound[0] + " " + live.bound[1] + " " + live.bound[2]));
  EXPECT_THAT(judged.err, HasSubstr("nothing arrived at " + live.bound[2]));
  EXPECT_THAT(judged.err, Not(HasSubstr("nothing arrived at " + live.bound[0])));
}

TEST(CheckProgram, WarnsOfASourceHeardWholeAndFiltered) {
  ManyLive live({"127.0.0.1:0", "127.0.0.1:0"}, "3s");
  ASSERT_EQ(live.senders.size(), 2U);
  ASSERT_TRUE(live.senders[0].send(bytesOf("RK1 me@a 10 -\njoints arm 1\n")).ok());
  ASSERT_TRUE(live.senders[1].send(bytesOf("RK1 me@a 10 - via=hub:slow:1\njoints arm 1\n")).ok());
  const test::ProgramResult judged = live.program->finish();
  EXPECT_THAT(judged.out, HasSubstr("[source.mixed]"));
  EXPECT_THAT(judged.out, HasSubstr("also filtered by relay hub:slow"));
}

TEST(CheckProgram, JudgesWhatARelaySends) {
  test::LoopbackRelay relay;
  ManyLive live({relay.endpoint() + "?source=me", "127.0.0.1:0"}, "6s");
  live.program->waitForLine("subscribed to relay hall at " + relay.endpoint() + "?source=me");
  ASSERT_TRUE(relay.send("RK1 me@a 1 -\njoints arm 1 2\n"));
  ASSERT_EQ(live.senders.size(), 1U);
  ASSERT_TRUE(live.senders[0].send(bytesOf("RKS1 leave id=0000000000000000\n")).ok());
  const test::ProgramResult judged = live.program->finish();
  EXPECT_EQ(judged.exit_code, 1) << judged.out << judged.err;
  EXPECT_THAT(judged.out, HasSubstr("[packet.joint-count]"));
  EXPECT_THAT(judged.out, HasSubstr("1 packet of 1 source"));
  EXPECT_THAT(judged.out, Not(HasSubstr("[packet.not-a-packet]")));
  relay.with([](const test::FakeRelay& each) { EXPECT_EQ(each.wanted.wish.source, "me"); });
}

TEST(CheckProgram, AnInterruptionTellsWhatWasFoundAndIsNeverYes) {
  LiveCheck fits("60s", "RK1 me@a - -\njoints arm 1\n");
  // Until the packet has arrived, there is nothing to stop for.
  ASSERT_TRUE(test::waitUntilTaken(fits.port()));
  const test::ProgramResult stopped = fits.program().stop();
  EXPECT_EQ(stopped.exit_code, 2);
  EXPECT_TRUE(stopped.out.ends_with("\ninterrupted: what was found so far is not all\n"))
      << stopped.out;
}

TEST(CheckProgram, JudgesTrafficThatHasItsOwnReceiver) {
  const test::NetworkNamespace network;
  ROCINANTE_NEEDS_NETWORK_NAMESPACE(network);
  const test::TemporaryFolder folder;
  std::ofstream(folder / "arm.urdf") << kProgramArm;
  const Result<UdpReceiver> receiver = UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value());
  ASSERT_TRUE(receiver.ok());
  Endpoint to = receiver->endpoint();
  to.address = receiver->boundAddress();
  const std::string filter = "?filter=udp port " + std::to_string(to.address.port);
  auto check = test::Program::start(
      "rocinante-check", {"arm.urdf", "--live", "pcap://lo" + filter, "--duration", "3s"},
      folder.path());
  check.waitForLine("listening on pcap://lo");
  Result<UdpSender> sender = UdpSender::open(to);
  ASSERT_TRUE(sender.ok());
  EXPECT_TRUE(sender->send(bytesOf(std::string_view("RK1 me@a - -\njoints arm 1 2\n"))).ok());
  const test::ProgramResult judged = check.finish();
  if (judged.err.find("without libpcap") != std::string::npos) GTEST_SKIP() << judged.err;
  EXPECT_EQ(judged.exit_code, 1) << judged.out << judged.err;
  EXPECT_THAT(judged.out, HasSubstr("[packet.joint-count]"));
}

}  // namespace
}  // namespace rocinante
