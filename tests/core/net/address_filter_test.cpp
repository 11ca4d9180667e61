#include "core/net/address_filter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace rocinante {
namespace {

using ::testing::HasSubstr;

SocketAddress addressOf(std::string_view host) { return SocketAddress::parse(host, 5).value(); }

AddressFilter filterOf(std::initializer_list<std::string_view> networks) {
  AddressFilter filter;
  for (const std::string_view each : networks) EXPECT_TRUE(filter.add(each).ok()) << each;
  return filter;
}

TEST(AddressFilter, ASenderOfIpv4AtASocketOfIpv6IsTheSameSender) {
  const AddressFilter filter = filterOf({"10.78.0.0/24"});
  EXPECT_TRUE(filter.allows(addressOf("::ffff:10.78.0.2")));
  EXPECT_FALSE(filter.allows(addressOf("::ffff:10.79.0.2")));
  EXPECT_FALSE(filter.allows(addressOf("::10.78.0.2")));
  EXPECT_TRUE(filterOf({"::ffff:0:0/96"}).allows(addressOf("::ffff:10.79.0.2")));
}

TEST(AddressFilter, AnEmptyOneAllowsEverybody) {
  EXPECT_TRUE(AddressFilter().allows(addressOf("10.0.0.1")));
  EXPECT_TRUE(AddressFilter().allows(addressOf("::1")));
}

TEST(AddressFilter, AllowsTheWholeNetworkAndNothingBeside) {
  const AddressFilter filter = filterOf({"10.1.0.0/16", "192.168.7.9", "fd00:1::/33", "::1/128"});
  for (const std::string_view host :
       {"10.1.0.0", "10.1.255.255", "192.168.7.9", "fd00:1::1", "fd00:1:7fff::", "::1"}) {
    EXPECT_TRUE(filter.allows(addressOf(host))) << host;
  }
  for (const std::string_view host : {"10.0.255.255", "10.2.0.0", "192.168.7.8",
                                      "fd00:1:8000::", "fd00:2::", "::2", "127.0.0.1"}) {
    EXPECT_FALSE(filter.allows(addressOf(host))) << host;
  }
}

TEST(AddressFilter, OneFamilySaysNothingOfTheOther) {
  EXPECT_FALSE(filterOf({"0.0.0.0/0"}).allows(addressOf("::1")));
  EXPECT_FALSE(filterOf({"::/0"}).allows(addressOf("10.0.0.1")));
  EXPECT_TRUE(filterOf({"0.0.0.0/0"}).allows(addressOf("255.1.2.3")));
}

TEST(AddressFilter, AZoneIsNoPartOfTheNetwork) {
  SocketAddress sender = addressOf("fe80::7");
  sender.scope_id = 3;
  EXPECT_TRUE(filterOf({"fe80::/10"}).allows(sender));
}

/// Compared with the definition, bit by bit.
TEST(AddressFilter, AgreesWithComparingBits) {
  std::mt19937 random(28);
  for (int round = 0; round < 3'000; ++round) {
    SocketAddress network;
    network.is_ipv6 = random() % 2 != 0;
    const unsigned bytes = network.is_ipv6 ? 16 : 4;
    for (unsigned i = 0; i < bytes; ++i) network.address[i] = static_cast<std::uint8_t>(random());
    const unsigned length = static_cast<unsigned>(random()) % (bytes * 8 + 1);
    for (unsigned bit = length; bit < bytes * 8; ++bit) {
      network.address[bit / 8] &= static_cast<std::uint8_t>(~(0x80U >> bit % 8));
    }
    AddressFilter filter;
    ASSERT_TRUE(filter.add(network.hostText() + "/" + std::to_string(length)).ok());
    SocketAddress sender = network;
    if (random() % 4 != 0) {
      const unsigned bit = static_cast<unsigned>(random()) % (bytes * 8);
      sender.address[bit / 8] ^= static_cast<std::uint8_t>(0x80U >> bit % 8);
      EXPECT_EQ(filter.allows(sender), bit >= length);
    } else {
      EXPECT_TRUE(filter.allows(sender));
    }
  }
}

TEST(AddressFilter, RefusesWhatSaysSomethingElseThanItSeems) {
  struct Refusal {
    std::string_view text, reason;
  };
  for (const Refusal& each : {
           Refusal{"10.0.0.5/8",
                   "this has bits beyond its prefix: is it 10.0.0.0/8 or "
                   "10.0.0.5/32?"},
           Refusal{"fd00::1/64", "is it fd00::/64 or fd00::1/128?"},
           Refusal{"10.0.0.0/33", "the prefix length must be a number from 0 to 32"},
           Refusal{"::/129", "the prefix length must be a number from 0 to 128"},
           Refusal{"10.0.0.0/", "the prefix length must be a number"},
           Refusal{"10.0.0.0/08", "the prefix length must be a number"},
           Refusal{"10.0.0.0/-1", "the prefix length must be a number"},
           Refusal{"10.0.0.0/8/8", "the prefix length must be a number"},
           Refusal{"robot7/32", "a network is ADDRESS/BITS"},
           Refusal{"", "a network is ADDRESS/BITS"},
           Refusal{"10.0/16", "a network is ADDRESS/BITS"},
       }) {
    SCOPED_TRACE(each.text);
    AddressFilter filter;
    const Status added = filter.add(each.text);
    ASSERT_FALSE(added.ok());
    EXPECT_EQ(added.error().kind, ErrorKind::bad_argument);
    EXPECT_THAT(added.error().what, HasSubstr(each.reason));
    EXPECT_TRUE(filter.empty());
  }
}

}  // namespace
}  // namespace rocinante
