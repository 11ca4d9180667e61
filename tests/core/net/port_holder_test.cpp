#include "core/net/port_holder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "core/net/udp_socket.h"

namespace rocinante {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// Two lines of a real /proc/net/udp: 127.0.0.1:19960 (inode 501) and 0.0.0.0:19961 (inode 502).
constexpr std::string_view kTable =
    "  sl  local_address rem_address   st tx_queue rx_queue tr tm->when retrnsmt   uid  timeout "
    "inode ref pointer drops             \n"
    " 1816: 0100007F:4DF8 00000000:0000 07 00000000:00000000 00:00000000 00000000     0        0 "
    "501 2 0000000000000000 0         \n"
    " 1817: 00000000:4DF9 00000000:0000 07 00000000:00000000 00:00000000 00000000  1000        0 "
    "502 2 0000000000000000 0         \n";

SocketAddress address(std::string_view host, std::uint16_t port) {
  return SocketAddress::parse(host, port).value();
}

TEST(ExcludingSocketInodes, FindsTheSameAddressAndPort) {
  EXPECT_THAT(excludingSocketInodes(kTable, address("127.0.0.1", 19960)), ElementsAre(501U));
}

TEST(ExcludingSocketInodes, AnyExcludesEveryAddressBothWays) {
  EXPECT_THAT(excludingSocketInodes(kTable, address("0.0.0.0", 19960)), ElementsAre(501U));
  EXPECT_THAT(excludingSocketInodes(kTable, address("10.0.0.1", 19961)), ElementsAre(502U));
}

TEST(ExcludingSocketInodes, LeavesOtherAddressesAndPortsAlone) {
  EXPECT_THAT(excludingSocketInodes(kTable, address("127.0.0.2", 19960)), IsEmpty());
  EXPECT_THAT(excludingSocketInodes(kTable, address("127.0.0.1", 19999)), IsEmpty());
  EXPECT_THAT(excludingSocketInodes(kTable, address("::1", 19961)), IsEmpty());
}

TEST(ExcludingSocketInodes, ReadsIpv6) {
  constexpr std::string_view table =
      "  sl  local_address                         remote_address                        st ...\n"
      " 1: 00000000000000000000000001000000:4DF8 00000000000000000000000000000000:0000 07 "
      "00000000:00000000 00:00000000 00000000     0        0 77 2 0000000000000000 0\n"
      " 2: 00000000000000000000000000000000:4DF8 00000000000000000000000000000000:0000 07 "
      "00000000:00000000 00:00000000 00000000     0        0 78 2 0000000000000000 0\n";
  EXPECT_THAT(excludingSocketInodes(table, address("::1", 19960)), ElementsAre(77U, 78U));
  EXPECT_THAT(excludingSocketInodes(table, address("127.0.0.1", 19960)), ElementsAre(78U));
}

TEST(ExcludingSocketInodes, SurvivesATableCutAnywhere) {
  for (std::size_t length = 0; length <= kTable.size(); ++length) {
    const std::string cut(kTable.substr(0, length));
    EXPECT_LE(excludingSocketInodes(cut, address("127.0.0.1", 19960)).size(), 1U);
  }
}

TEST(PortHolder, NamesThisProcess) {
  const auto receiver = UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value());
  ASSERT_TRUE(receiver.ok()) << receiver.error().text();
  const auto holder = portHolder(receiver->boundAddress());
  ASSERT_TRUE(holder);
  EXPECT_EQ(holder->pid, ::getpid());
  EXPECT_EQ(holder->name, "network_tests");
}

TEST(PortHolder, IsNobodyForAFreePort) {
  SocketAddress freed;
  {
    const auto receiver = UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value());
    ASSERT_TRUE(receiver.ok());
    freed = receiver->boundAddress();
  }
  EXPECT_FALSE(portHolder(freed));
}

}  // namespace
}  // namespace rocinante
