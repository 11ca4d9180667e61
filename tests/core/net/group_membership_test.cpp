#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include "core/net/udp_socket.h"
#include "tests/support/network_namespace.h"

// Groups on interfaces that disappear and return, in the test's own network name space.
namespace rocinante {
namespace {

using test::NetworkNamespace;
using ::testing::HasSubstr;

constexpr const char* kMake =
    "ip link add cell0 type veth peer name robot0 && ip addr add 10.9.0.1/24 dev cell0 && "
    "ip link set cell0 up && ip link set robot0 up && "
    "sysctl -qw net.ipv6.conf.cell0.accept_dad=0 && ip -6 addr add fd09::1/64 dev cell0 nodad";

/// Calls maintain() until it returns a sentence, for a limited time: the kernel reports interfaces
/// with a delay.
std::string said(UdpReceiver& receiver, int within_ms = 5'000) {
  for (int waited = 0; waited < within_ms; waited += 5) {
    if (auto sentence = receiver.maintain()) return *sentence;
    ::poll(nullptr, 0, 5);
  }
  return {};
}

/// Sends until one arrives: an interface that comes up needs a moment before it carries traffic.
bool hears(UdpReceiver& receiver, const std::string& word) {
  for (int attempt = 0; attempt < 200; ++attempt) {
    Endpoint to = receiver.endpoint();
    to.address.port = receiver.boundAddress().port;
    auto sender = UdpSender::open(to);
    if (sender) (void)sender->send(bytesOf(word));
    pollfd readable{receiver.fileDescriptor(), POLLIN, 0};
    ::poll(&readable, 1, 20);
    const auto batch = receiver.receive();
    EXPECT_TRUE(batch.ok());
    if (!batch) return false;
    for (const ReceivedDatagram& each : *batch) {
      if (textOf(each.payload) == word) return true;
    }
  }
  return false;
}

void expectHeardAgain(const std::string& endpoint) {
  SCOPED_TRACE(endpoint);
  const NetworkNamespace network;
  ROCINANTE_NEEDS_NETWORK_NAMESPACE(network);
  ASSERT_TRUE(NetworkNamespace::run(kMake));
  auto receiver = UdpReceiver::open(Endpoint::parse(endpoint).value());
  ASSERT_TRUE(receiver.ok()) << receiver.error().text();
  const std::uint16_t port = receiver->boundAddress().port;
  EXPECT_TRUE(hears(*receiver, "before"));

  // Down and up: the kernel keeps the membership.
  ASSERT_TRUE(
      NetworkNamespace::run("ip link set cell0 down && ip link set cell0 up && "
                            "{ ip -6 addr add fd09::1/64 dev cell0 nodad || true; }"));
  EXPECT_TRUE(hears(*receiver, "up again"));

  for (int round = 0; round < 2; ++round) {
    ASSERT_TRUE(NetworkNamespace::run("ip link del cell0"));
    EXPECT_THAT(said(*receiver), HasSubstr("; nothing is received until it returns"));
    EXPECT_EQ(said(*receiver, 50), "");
    ASSERT_TRUE(NetworkNamespace::run(kMake));
    EXPECT_EQ(said(*receiver), "joined " + receiver->endpoint().text() + " again");
    EXPECT_TRUE(hears(*receiver, "made anew"));
    EXPECT_EQ(receiver->boundAddress().port, port);
  }
  EXPECT_EQ(receiver->droppedByNow().value(), 0U);
}

TEST(GroupMembership, AnInterfaceMadeAnewIsJoinedAgain) {
  expectHeardAgain("udp://239.1.2.3:0?interface=cell0");
}

TEST(GroupMembership, AnInterfaceMadeAnewIsJoinedAgainForOneSender) {
  expectHeardAgain("udp://232.1.2.3:0?interface=cell0&source=10.9.0.1");
}

TEST(GroupMembership, AnInterfaceMadeAnewIsJoinedAgainOverIpv6) {
  expectHeardAgain("udp://[ff15::1996]:0?interface=cell0");
}

TEST(GroupMembership, AGroupOfALinkIsListenedToAnew) {
  expectHeardAgain("udp://[ff12::1996]:0?interface=cell0");
}

TEST(GroupMembership, GoneAndBackBetweenTwoLooksIsNoticed) {
  const NetworkNamespace network;
  ROCINANTE_NEEDS_NETWORK_NAMESPACE(network);
  // The index is the same too: only the kernel's notification shows that it is a new interface.
  const std::string make =
      "ip link add cell0 index 77 type veth peer name robot0 && ip link set robot0 up && ip addr "
      "add 10.9.0.1/24 dev cell0 && "
      "ip link set cell0 up";
  ASSERT_TRUE(NetworkNamespace::run(make));
  auto receiver = UdpReceiver::open(Endpoint::parse("udp://239.1.2.3:0?interface=cell0").value());
  ASSERT_TRUE(receiver.ok()) << receiver.error().text();
  ASSERT_TRUE(NetworkNamespace::run("ip link del cell0 && " + make));
  EXPECT_THAT(said(*receiver), HasSubstr("joined "));
  EXPECT_TRUE(hears(*receiver, "again"));
}

TEST(GroupMembership, WithoutANamedInterfaceItFollowsTheRoute) {
  const NetworkNamespace network;
  ROCINANTE_NEEDS_NETWORK_NAMESPACE(network);
  ASSERT_TRUE(NetworkNamespace::run(
      "for n in 1 2; do ip link add cell$n type veth peer name robot$n && "
      "ip addr add 10.9.$n.1/24 dev cell$n && ip link set robot$n up && ip link set cell$n up || "
      "exit 1; done; ip route add 239.0.0.0/8 dev cell1"));
  auto receiver = UdpReceiver::open(Endpoint::parse("udp://239.1.2.3:0").value());
  ASSERT_TRUE(receiver.ok()) << receiver.error().text();
  EXPECT_TRUE(hears(*receiver, "by cell1"));
  ASSERT_TRUE(NetworkNamespace::run("ip route replace 239.0.0.0/8 dev cell2"));
  EXPECT_THAT(said(*receiver), HasSubstr("joined "));
  EXPECT_TRUE(hears(*receiver, "by cell2"));
}

TEST(GroupMembership, WhatWaitsInTheOldSocketIsStillReceived) {
  const NetworkNamespace network;
  ROCINANTE_NEEDS_NETWORK_NAMESPACE(network);
  ASSERT_TRUE(NetworkNamespace::run(kMake));
  auto receiver = UdpReceiver::open(Endpoint::parse("udp://[ff12::7]:0?interface=cell0").value());
  ASSERT_TRUE(receiver.ok()) << receiver.error().text();
  ASSERT_TRUE(hears(*receiver, "warm"));
  Endpoint to = receiver->endpoint();
  to.address.port = receiver->boundAddress().port;
  auto sender = UdpSender::open(to);
  ASSERT_TRUE(sender.ok());
  for (int i = 0; i < 300; ++i) ASSERT_TRUE(sender->send(bytesOf(std::to_string(i))).ok());
  ASSERT_TRUE(NetworkNamespace::run("ip link del cell0") && NetworkNamespace::run(kMake));
  EXPECT_THAT(said(*receiver), HasSubstr("joined "));
  int next = 0;
  for (;;) {
    const auto batch = receiver->receive();
    ASSERT_TRUE(batch.ok());
    if (batch->empty()) break;
    for (const ReceivedDatagram& each : *batch) {
      if (textOf(each.payload) == "warm") continue;
      EXPECT_EQ(textOf(each.payload), std::to_string(next++));
    }
  }
  EXPECT_EQ(next, 300);
  EXPECT_TRUE(hears(*receiver, "again"));
}

}  // namespace
}  // namespace rocinante
