#include <gtest/gtest.h>

#include <string>

#include "core/net/endpoint.h"

namespace rocinante {
namespace {

TEST(SocketAddress, ReadsADottedQuad) {
  const auto address = SocketAddress::parse("192.168.1.20", 7);
  ASSERT_TRUE(address.ok());
  EXPECT_FALSE(address->is_ipv6);
  EXPECT_EQ(address->address[0], 192);
  EXPECT_EQ(address->address[3], 20);
  EXPECT_EQ(address->text(), "192.168.1.20:7");
}

TEST(SocketAddress, ReadsIpv6AndWritesItWithBrackets) {
  const auto address = SocketAddress::parse("2001:DB8:0:0::1", 7);
  ASSERT_TRUE(address.ok());
  EXPECT_TRUE(address->is_ipv6);
  EXPECT_EQ(address->hostText(), "2001:db8::1");
  EXPECT_EQ(address->text(), "[2001:db8::1]:7");
}

TEST(SocketAddress, KeepsTheZoneOfALinkLocalAddressByName) {
  const auto address = SocketAddress::parse("fe80::1%lo", 7);
  ASSERT_TRUE(address.ok());
  EXPECT_NE(address->scope_id, 0U);
  EXPECT_EQ(address->text(), "[fe80::1%lo]:7");
}

TEST(SocketAddress, KeepsAZoneWhoseInterfaceIsNotHereByNumber) {
  const auto address = SocketAddress::parse("fe80::1%4000000", 7);
  ASSERT_TRUE(address.ok());
  EXPECT_EQ(address->text(), "[fe80::1%4000000]:7");
}

TEST(SocketAddress, RefusesWhatIsNoAddress) {
  for (const std::string_view host :
       {"", "localhost", "1.2.3", "1.2.3.4.5", "256.1.1.1", "1.2.3.4%lo", "0x7f.0.0.1",
        ":::", "fe80::1%no-such-interface", "::1%lo", "fe80::1%", "1.2.3.4 ", "g::1"}) {
    SCOPED_TRACE(host);
    const auto address = SocketAddress::parse(host, 1);
    ASSERT_FALSE(address.ok());
    EXPECT_EQ(address.error().kind, ErrorKind::bad_argument);
  }
  EXPECT_FALSE(SocketAddress::parse(std::string_view("1.2.3.4\0x", 9), 1).ok());
}

TEST(SocketAddress, KnowsMulticastAndAny) {
  EXPECT_TRUE(SocketAddress::parse("224.0.0.1", 1)->isMulticast());
  EXPECT_TRUE(SocketAddress::parse("239.255.255.255", 1)->isMulticast());
  EXPECT_FALSE(SocketAddress::parse("223.255.255.255", 1)->isMulticast());
  EXPECT_FALSE(SocketAddress::parse("240.0.0.1", 1)->isMulticast());
  EXPECT_TRUE(SocketAddress::parse("ff02::1", 1)->isMulticast());
  EXPECT_FALSE(SocketAddress::parse("fe80::1", 1)->isMulticast());
  EXPECT_TRUE(SocketAddress::parse("0.0.0.0", 1)->isAny());
  EXPECT_TRUE(SocketAddress::parse("::", 1)->isAny());
  EXPECT_FALSE(SocketAddress::parse("::1", 1)->isAny());
}

}  // namespace
}  // namespace rocinante
