#include "core/net/udp_socket.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <net/if.h>
#include <poll.h>
#include <unistd.h>

#include <memory>
#include <string>
#include <vector>

#include "tests/support/network_namespace.h"

namespace rocinante {
namespace {

using ::testing::HasSubstr;

Endpoint endpointOf(std::string_view text) { return Endpoint::parse(text).value(); }

/// `to` with the port assigned to `receiver`.
Endpoint reach(const UdpReceiver& receiver) {
  Endpoint to = receiver.endpoint();
  to.address.port = receiver.boundAddress().port;
  return to;
}

/// The datagrams received until there are `count`, or none arrived for two seconds.
std::vector<std::string> receiveAll(UdpReceiver& receiver, std::size_t count) {
  std::vector<std::string> payloads;
  while (payloads.size() < count) {
    pollfd readable{receiver.fileDescriptor(), POLLIN, 0};
    if (::poll(&readable, 1, 2'000) <= 0) break;
    const auto batch = receiver.receive();
    if (!batch) break;
    for (const ReceivedDatagram& each : *batch) payloads.emplace_back(textOf(each.payload));
  }
  return payloads;
}

/// Sends datagrams of every awkward size and expects each back byte-equal, in order.
void expectRoundTrip(const Endpoint& listen) {
  auto receiver = UdpReceiver::open(listen);
  ASSERT_TRUE(receiver.ok()) << receiver.error().text();
  auto sender = UdpSender::open(reach(*receiver));
  ASSERT_TRUE(sender.ok()) << sender.error().text();
  std::vector<std::string> sent;
  for (const std::size_t size : {0U, 1U, 1'200U, 1'473U, 9'000U, 65'507U}) {
    sent.emplace_back(size, static_cast<char>('a' + sent.size()));
  }
  for (int i = 0; i < 300; ++i) sent.push_back("datagram " + std::to_string(i));
  std::vector<ByteView> views;
  for (const std::string& each : sent) views.push_back(bytesOf(each));
  const Status done = sender->send(views);
  ASSERT_TRUE(done.ok()) << done.error().text();
  EXPECT_EQ(receiveAll(*receiver, sent.size()), sent);
  EXPECT_EQ(receiver->droppedByNow().value(), 0U);
}

TEST(UdpSocket, CarriesDatagramsOverIpv4) { expectRoundTrip(endpointOf("127.0.0.1:0")); }

TEST(UdpSocket, CarriesDatagramsOverIpv6) { expectRoundTrip(endpointOf("[::1]:0")); }

TEST(UdpSocket, CarriesDatagramsToAGroupOnLoopback) {
  expectRoundTrip(endpointOf("udp://239.255.19.96:0?interface=lo&ttl=0"));
}

TEST(UdpSocket, CarriesDatagramsToAnIpv6Group) {
  // Interface-local groups (ff01::/16) never leave the machine, but lo itself has no route to them.
  const std::unique_ptr<struct if_nameindex, void (*)(struct if_nameindex*)> interfaces(
      ::if_nameindex(), ::if_freenameindex);
  ASSERT_NE(interfaces, nullptr);
  for (const struct if_nameindex* each = interfaces.get(); each->if_index != 0; ++each) {
    const auto listen =
        Endpoint::parse(std::string("[ff01::1996]:0?ttl=0&interface=") + each->if_name);
    if (!listen) continue;
    auto receiver = UdpReceiver::open(*listen);
    if (!receiver || !UdpSender::open(reach(*receiver))) continue;
    auto sender = UdpSender::open(reach(*receiver));
    if (!sender || !sender->send(bytesOf("hello"))) continue;
    EXPECT_EQ(receiveAll(*receiver, 1), std::vector<std::string>{"hello"});
    return;
  }
  GTEST_SKIP() << "no interface here takes IPv6 multicast";
}

TEST(UdpSocket, StampsWithTheKernelsTimeAndTheSendersAddress) {
  auto receiver = UdpReceiver::open(endpointOf("127.0.0.1:0"));
  ASSERT_TRUE(receiver.ok());
  auto sender = UdpSender::open(reach(*receiver));
  ASSERT_TRUE(sender.ok());
  const auto before = std::chrono::system_clock::now();
  ASSERT_TRUE(sender->send(bytesOf("x")).ok());
  const auto after = std::chrono::system_clock::now();
  const auto batch = receiver->receive();
  ASSERT_TRUE(batch.ok());
  ASSERT_EQ(batch->size(), 1U);
  EXPECT_EQ(batch->front().sender, sender->localAddress());
  EXPECT_FALSE(batch->front().truncated);
  // The first stamps after a socket asks for them may be taken at receive() instead.
  EXPECT_GE(batch->front().kernel_time, before - std::chrono::milliseconds(5));
  EXPECT_LE(batch->front().kernel_time, after + std::chrono::seconds(2));
}

TEST(UdpReceiver, IsEmptyWhenNothingWaits) {
  auto receiver = UdpReceiver::open(endpointOf("127.0.0.1:0"));
  ASSERT_TRUE(receiver.ok());
  const auto batch = receiver->receive();
  ASSERT_TRUE(batch.ok());
  EXPECT_TRUE(batch->empty());
}

TEST(UdpReceiver, CutsAndMarksALongerDatagram) {
  auto receiver = UdpReceiver::open(endpointOf("127.0.0.1:0"), {.datagram_bytes = 8});
  ASSERT_TRUE(receiver.ok());
  auto sender = UdpSender::open(reach(*receiver));
  ASSERT_TRUE(sender.ok());
  ASSERT_TRUE(sender->send(bytesOf("12345678")).ok());
  ASSERT_TRUE(sender->send(bytesOf("123456789")).ok());
  const auto batch = receiver->receive();
  ASSERT_TRUE(batch.ok());
  ASSERT_EQ(batch->size(), 2U);
  EXPECT_FALSE((*batch)[0].truncated);
  EXPECT_TRUE((*batch)[1].truncated);
  EXPECT_EQ(textOf((*batch)[1].payload), "12345678");
}

TEST(UdpReceiver, CountsEveryDropOfTheKernel) {
  auto receiver = UdpReceiver::open(endpointOf("127.0.0.1:0"), {.receive_buffer_bytes = 4'096});
  ASSERT_TRUE(receiver.ok());
  auto sender = UdpSender::open(reach(*receiver));
  ASSERT_TRUE(sender.ok());
  const std::string payload(100, 'x');
  std::uint64_t received = 0;
  constexpr int kRounds = 5;
  constexpr int kEach = 1'000;
  for (int round = 0; round < kRounds; ++round) {
    for (int i = 0; i < kEach; ++i) ASSERT_TRUE(sender->send(bytesOf(payload)).ok());
    for (;;) {
      const auto batch = receiver->receive();
      ASSERT_TRUE(batch.ok());
      if (batch->empty()) break;
      received += batch->size();
    }
  }
  // The last round's drops came after the last datagram with a count.
  EXPECT_LT(receiver->dropped() + received, std::uint64_t{kRounds} * kEach);
  EXPECT_EQ(receiver->droppedByNow().value() + received, std::uint64_t{kRounds} * kEach);
  EXPECT_EQ(receiver->dropped() + received, std::uint64_t{kRounds} * kEach);
  EXPECT_GT(receiver->dropped(), 0U);
}

TEST(UdpReceiver, RefusesATakenPortAndNamesItsHolder) {
  const auto first = UdpReceiver::open(endpointOf("127.0.0.1:0"));
  ASSERT_TRUE(first.ok());
  const std::string port = std::to_string(first->boundAddress().port);
  for (const std::string& host : {std::string("127.0.0.1"), std::string("")}) {
    SCOPED_TRACE(host);
    const auto second = UdpReceiver::open(endpointOf(host + ":" + port));
    ASSERT_FALSE(second.ok());
    EXPECT_EQ(second.error().kind, ErrorKind::refused);
    EXPECT_EQ(second.error().what, "port " + port + " is held by network_tests (pid " +
                                       std::to_string(::getpid()) +
                                       "); use multicast, a relay, --tee or pcap://");
  }
}

TEST(UdpReceiver, ListenersToOneGroupGetACopyEach) {
  auto first = UdpReceiver::open(endpointOf("udp://239.255.19.97:0?interface=lo"));
  ASSERT_TRUE(first.ok()) << first.error().text();
  auto second = UdpReceiver::open(reach(*first));
  ASSERT_TRUE(second.ok()) << second.error().text();
  auto sender = UdpSender::open(reach(*first));
  ASSERT_TRUE(sender.ok());
  ASSERT_TRUE(sender->send(bytesOf("both")).ok());
  EXPECT_EQ(receiveAll(*first, 1), std::vector<std::string>{"both"});
  EXPECT_EQ(receiveAll(*second, 1), std::vector<std::string>{"both"});
}

TEST(UdpReceiver, HearsOnlyTheSourceThatTheEndpointNames) {
  auto receiver =
      UdpReceiver::open(endpointOf("udp://239.255.19.98:0?interface=lo&ttl=0&source=127.0.0.2"));
  ASSERT_TRUE(receiver.ok()) << receiver.error().text();
  Endpoint to = reach(*receiver);
  to.source = SocketAddress::parse("127.0.0.1", 0).value();
  auto other = UdpSender::open(to);
  ASSERT_TRUE(other.ok()) << other.error().text();
  auto wanted = UdpSender::open(reach(*receiver));
  ASSERT_TRUE(wanted.ok()) << wanted.error().text();
  EXPECT_EQ(wanted->localAddress().hostText(), "127.0.0.2");
  ASSERT_TRUE(other->send(bytesOf("other")).ok());
  ASSERT_TRUE(wanted->send(bytesOf("wanted")).ok());
  EXPECT_EQ(receiveAll(*receiver, 1), std::vector<std::string>{"wanted"});
}

TEST(UdpReceiver, SaysWhichInterfaceIsNotThere) {
  const auto receiver = UdpReceiver::open(endpointOf("239.255.19.96:0?interface=nowhere0"));
  ASSERT_FALSE(receiver.ok());
  EXPECT_THAT(receiver.error().what,
              HasSubstr("there is no network interface nowhere0; there are "));
  EXPECT_THAT(receiver.error().what, HasSubstr("lo"));
  EXPECT_EQ(receiver.error().where, "udp://239.255.19.96:0?interface=nowhere0");
}

TEST(UdpReceiver, RefusesAnAddressOfAnotherMachine) {
  // 192.0.2.0/24 is for documentation; no machine has .199.
  const auto receiver = UdpReceiver::open(endpointOf("192.0.2.199:0"));
  ASSERT_FALSE(receiver.ok());
  EXPECT_THAT(receiver.error().what, HasSubstr("cannot listen here"));
}

TEST(UdpSender, NeedsAHostAndAPort) {
  EXPECT_EQ(UdpSender::open(endpointOf(":19960")).error().kind, ErrorKind::bad_argument);
  EXPECT_EQ(UdpSender::open(endpointOf("127.0.0.1:0")).error().kind, ErrorKind::bad_argument);
}

TEST(UdpSender, IsNotForWatchedTraffic) {
  for (const std::string_view text : {"pcap://lo", "pcap:///tmp/x.pcap"}) {
    EXPECT_EQ(UdpSender::open(endpointOf(text)).error().kind, ErrorKind::bad_argument);
    EXPECT_THAT(UdpReceiver::open(endpointOf(text)).error().what,
                HasSubstr("pcap:// only watches"));
  }
}

TEST(UdpSender, LosesNothingToEarlierRefusals) {
  Endpoint to;
  {
    const auto gone = UdpReceiver::open(endpointOf("127.0.0.1:0"));
    ASSERT_TRUE(gone.ok());
    to = reach(*gone);
  }
  auto sender = UdpSender::open(to);
  ASSERT_TRUE(sender.ok());
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(sender->send(bytesOf("nobody hears this")).ok());
  auto receiver = UdpReceiver::open(to);
  if (!receiver) GTEST_SKIP() << "another process took the port meanwhile";
  std::vector<std::string> sent;
  for (int i = 0; i < 10; ++i) {
    sent.push_back(std::to_string(i));
    ASSERT_TRUE(sender->send(bytesOf(sent.back())).ok());
  }
  EXPECT_EQ(receiveAll(*receiver, sent.size()), sent);
}

TEST(UdpSender, ReachesAllMachinesOfANetworkByBroadcast) {
  const test::NetworkNamespace network;
  ROCINANTE_NEEDS_NETWORK_NAMESPACE(network);
  ASSERT_TRUE(network.run(
      "ip link add cell0 type veth peer name robot0 && ip addr add 10.9.0.1/24 brd + dev cell0 && "
      "ip link set robot0 up && ip link set cell0 up && ip route add default dev cell0"));
  auto everything = UdpReceiver::open(endpointOf(":5000"));
  auto broadcasts = UdpReceiver::open(endpointOf("10.9.0.255:5001"));
  auto own = UdpReceiver::open(endpointOf("10.9.0.1:5002"));
  ASSERT_TRUE(everything.ok() && broadcasts.ok() && own.ok());
  for (const char* const to : {"10.9.0.255:5000", "255.255.255.255:5000", "10.9.0.255:5001",
                               "10.9.0.1:5001", "10.9.0.255:5002", "10.9.0.1:5002"}) {
    auto sender = UdpSender::open(endpointOf(to));
    ASSERT_TRUE(sender.ok()) << sender.error().text();
    const Status sent = sender->send(bytesOf(std::string_view(to)));
    ASSERT_TRUE(sent.ok()) << sent.error().text();
  }
  EXPECT_EQ(receiveAll(*everything, 2),
            (std::vector<std::string>{"10.9.0.255:5000", "255.255.255.255:5000"}));
  EXPECT_EQ(receiveAll(*broadcasts, 1), (std::vector<std::string>{"10.9.0.255:5001"}));
  // A listener at one address hears only what is sent to that address.
  EXPECT_EQ(receiveAll(*own, 1), (std::vector<std::string>{"10.9.0.1:5002"}));
  EXPECT_TRUE(broadcasts->receive()->empty());
  EXPECT_TRUE(own->receive()->empty());
}

TEST(UdpSender, SaysWhenADatagramIsTooLong) {
  auto receiver = UdpReceiver::open(endpointOf("127.0.0.1:0"));
  ASSERT_TRUE(receiver.ok());
  auto sender = UdpSender::open(reach(*receiver));
  ASSERT_TRUE(sender.ok());
  const std::string payload(65'508, 'x');
  const Status done = sender->send(bytesOf(payload));
  ASSERT_FALSE(done.ok());
  EXPECT_EQ(done.error().what, "a datagram of 65508 bytes is too long for the network");
}

}  // namespace
}  // namespace rocinante
