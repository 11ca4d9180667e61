#include <gtest/gtest.h>

#include "core/net/interfaces.h"
#include "tests/support/network_namespace.h"

namespace rocinante {
namespace {

bool isOwn(const char* address) { return isOwnAddress(SocketAddress::parse(address, 1).value()); }

TEST(LocalAddress, KnowsThisMachinesOwn) {
  EXPECT_TRUE(isOwn("127.4.5.6"));
  EXPECT_TRUE(isOwn("::1"));
  EXPECT_TRUE(isOwn("::ffff:127.0.0.1"));
  EXPECT_FALSE(isOwn("::ffff:198.51.100.1"));
  EXPECT_FALSE(isOwn("198.51.100.1"));
  EXPECT_FALSE(isOwn("2001:db8::1"));
}

// Machines that fail over to each other let programs bind to addresses that they do not have yet.
TEST(LocalAddress, IsNotWhateverABindTakes) {
  const test::NetworkNamespace network;
  ROCINANTE_NEEDS_NETWORK_NAMESPACE(network);
  ASSERT_TRUE(network.run("ip link add eth1 type veth peer name site2"));
  ASSERT_TRUE(network.run("ip addr add 192.0.2.1/24 dev eth1"));
  ASSERT_TRUE(network.run("ip addr add 2001:db8::1/64 dev eth1 nodad"));
  if (!network.run("echo 1 >/proc/sys/net/ipv4/ip_nonlocal_bind")) {
    GTEST_SKIP() << "net.ipv4.ip_nonlocal_bind cannot be set here";
  }
  EXPECT_TRUE(isOwn("192.0.2.1"));
  EXPECT_TRUE(isOwn("2001:db8::1"));
  EXPECT_FALSE(isOwn("192.0.2.7"));
  EXPECT_FALSE(isOwn("2001:db8::7"));
}

}  // namespace
}  // namespace rocinante
