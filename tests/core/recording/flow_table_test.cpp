#include "core/recording/flow_table.h"

#include <gtest/gtest.h>

#include <set>

namespace rocinante {
namespace {

ListenedEndpoint listening(std::string_view text, std::uint16_t port) {
  ListenedEndpoint listened;
  listened.endpoint = Endpoint::parse(text).value();
  listened.bound = listened.endpoint.address;
  listened.bound.port = port;
  return listened;
}

SocketAddress sender(std::uint16_t port, std::string_view host = "10.0.0.7") {
  return SocketAddress::parse(host, port).value();
}

TEST(FlowTable, NamesATopicByPortAndSource) {
  FlowTable table({listening(":0", 19960)});
  const std::size_t index = table.channelOf({0, sender(4000), "arm", true, false});
  const FlowChannel& channel = table.channels()[index];
  EXPECT_EQ(channel.topic, "/udp/19960/arm");
  EXPECT_EQ(channel.encoding, "rk1");
  EXPECT_EQ(channel.metadata, (std::map<std::string, std::string>{{"local", "0.0.0.0:19960"},
                                                                  {"remote", "10.0.0.7:4000"},
                                                                  {"protocol", "udp"},
                                                                  {"source", "arm"}}));
}

TEST(FlowTable, NamesATopicByAddressWhereThereIsNoSource) {
  FlowTable table({listening("[::]:7", 7)});
  const auto index = table.channelOf({0, sender(4000, "2001:db8::5"), "", false, false});
  EXPECT_EQ(table.channels()[index].topic, "/udp/7/2001:db8::5");
  EXPECT_EQ(table.channels()[index].encoding, "octets");
  EXPECT_EQ(table.channels()[index].metadata.count("source"), 0U);
}

TEST(FlowTable, NamesTheGroupOfMulticast) {
  FlowTable table({listening("239.1.2.3:5?interface=lo", 5), listening("[ff02::9]:6", 6)});
  const auto first = table.channelOf({0, sender(1), "arm", true, false});
  EXPECT_EQ(table.channels()[first].topic, "/udp/239.1.2.3:5/arm");
  EXPECT_EQ(table.channels()[first].metadata.at("group"), "239.1.2.3");
  EXPECT_EQ(table.channels()[first].metadata.at("interface"), "lo");
  const auto second = table.channelOf({1, sender(1, "fe80::1"), "arm", true, false});
  EXPECT_EQ(table.channels()[second].topic, "/udp/[ff02::9]:6/arm");
}

TEST(FlowTable, NamesTheRelayOfASubscription) {
  FlowTable table({listening("subscribe://10.0.0.7:19961?device=arm*", 40'123),
                   listening("subscribe://[fe80::1%lo]:5", 40'124)});
  const auto first = table.channelOf({0, sender(19'961), "arm", true, false});
  EXPECT_EQ(table.channels()[first].topic, "/subscribe/10.0.0.7:19961/arm");
  EXPECT_EQ(table.channels()[first].metadata.at("remote"), "10.0.0.7:19961");
  const auto greeting = table.channelOf({0, sender(19'961), "arm", true, true});
  EXPECT_EQ(table.channels()[greeting].topic, "/rocinante/restated/subscribe/10.0.0.7:19961/arm");
  const auto second = table.channelOf({1, sender(5, "fe80::1"), "arm", true, false});
  EXPECT_EQ(table.channels()[second].topic, "/subscribe/[fe80::1]:5/arm");
}

TEST(FlowTable, NamesWatchedTrafficByWhereItWasSent) {
  FlowTable table({listening("pcap://eth0?filter=udp", 0)});
  const SocketAddress to = sender(19'960, "10.0.0.9");
  const SocketAddress group = sender(5, "239.1.2.3");
  const auto first = table.channelOf({0, sender(4000), "arm", true, false, &to});
  EXPECT_EQ(table.channels()[first].topic, "/udp/19960/arm");
  EXPECT_EQ(table.channels()[first].metadata,
            (std::map<std::string, std::string>{{"local", "10.0.0.9:19960"},
                                                {"remote", "10.0.0.7:4000"},
                                                {"protocol", "udp"},
                                                {"interface", "eth0"},
                                                {"source", "arm"}}));
  const auto second = table.channelOf({0, sender(4000), "arm", true, true, &group});
  EXPECT_EQ(table.channels()[second].topic, "/rocinante/restated/udp/239.1.2.3:5/arm");
  EXPECT_EQ(table.channels()[second].metadata.at("group"), "239.1.2.3");
  // A different receiver makes a different flow; equal addresses are one.
  const SocketAddress other = sender(19'960, "10.0.0.10");
  const SocketAddress again = to;
  EXPECT_NE(table.channelOf({0, sender(4000), "arm", true, false, &other}), first);
  EXPECT_EQ(table.channelOf({0, sender(4000), "arm", true, false, &again}), first);
}

TEST(FlowTable, WatchedTrafficBeyondTheBoundSharesOneChannel) {
  FlowTable table({listening("pcap://eth0", 0)});
  std::size_t last = 0;
  for (unsigned i = 0; i < FlowTable::kFlowsAnEndpoint + 9; ++i) {
    const SocketAddress to = sender(static_cast<std::uint16_t>(i), "10.0.0.9");
    last = table.channelOf({0, sender(4000), "", false, false, &to});
  }
  EXPECT_EQ(table.channels().size(), FlowTable::kFlowsAnEndpoint + 1);
  EXPECT_EQ(table.channels()[last].topic, "/udp/_many");
  EXPECT_EQ(table.channels()[last].metadata.count("local"), 0U);
}

TEST(FlowTable, KeepsRestatementsOfOthersApart) {
  FlowTable table({listening(":9", 9)});
  const auto own = table.channelOf({0, sender(1), "arm", true, false});
  const auto restated = table.channelOf({0, sender(1), "arm", true, true});
  EXPECT_NE(own, restated);
  EXPECT_EQ(table.channels()[restated].topic, "/rocinante/restated/udp/9/arm");
}

TEST(FlowTable, AChannelIsEndpointSenderSourceAndEncoding) {
  FlowTable table({listening(":8", 8), listening(":9", 9)});
  const std::vector<Flow> flows{
      {0, sender(1), "a", true, false}, {1, sender(1), "a", true, false},
      {0, sender(2), "a", true, false}, {0, sender(1), "b", true, false},
      {0, sender(1), "", true, false},  {0, sender(1), "", false, false},
      {0, sender(1), "a", true, true},  {0, sender(1, "10.0.0.8"), "a", true, false}};
  std::set<std::size_t> seen;
  for (const Flow& flow : flows) EXPECT_TRUE(seen.insert(table.channelOf(flow)).second);
  for (const Flow& flow : flows) EXPECT_FALSE(seen.insert(table.channelOf(flow)).second);
  // A restarted sender gets another port: the same topic, another channel.
  EXPECT_EQ(table.channels()[0].topic, table.channels()[2].topic);
}

TEST(FlowTable, ATopicHoldsNothingThatASourceCouldForge) {
  FlowTable table({listening(":9", 9)});
  const auto index = table.channelOf({0, sender(1), "a/../\n\xff%b", true, false});
  EXPECT_EQ(table.channels()[index].topic, "/udp/9/a%2F..%2F%0A%FF%25b");
}

TEST(FlowTable, AFloodOfStrangersSharesOneChannelAnEndpoint) {
  FlowTable table({listening(":8", 8), listening("239.1.2.3:9", 9)});
  for (std::size_t i = 0; i < 3 * FlowTable::kFlowsAnEndpoint; ++i) {
    std::string name = "s";
    name += std::to_string(i);
    table.channelOf({0, sender(static_cast<std::uint16_t>(i)), name, true, false});
  }
  EXPECT_EQ(table.channels().size(), FlowTable::kFlowsAnEndpoint + 1);
  EXPECT_EQ(table.channels().back().topic, "/udp/8/_many");
  EXPECT_EQ(table.channels().back().metadata.count("remote"), 0U);
  const auto octets = table.channelOf({0, sender(1), "", false, false});
  EXPECT_EQ(table.channels()[octets].topic, "/udp/8/_many");
  EXPECT_EQ(table.channels()[octets].encoding, "octets");
  const auto restated = table.channelOf({0, sender(1), "zz", true, true});
  EXPECT_EQ(table.channels()[restated].topic, "/rocinante/restated/udp/8/_many");
  // Earlier flows keep their channels, and other endpoints have limits of their own.
  EXPECT_EQ(table.channelOf({0, sender(0), "s0", true, false}), 0U);
  const auto other = table.channelOf({1, sender(1), "zz", true, false});
  EXPECT_EQ(table.channels()[other].topic, "/udp/239.1.2.3:9/zz");
}

TEST(FlowTable, NeverMakesMoreChannelsThanALogHas) {
  std::vector<ListenedEndpoint> endpoints;
  for (std::uint16_t i = 0; i < 256; ++i) endpoints.push_back(listening(":1", i));
  FlowTable table(endpoints);
  for (std::uint32_t i = 0; i < 200'000; ++i) {
    const std::string name = std::to_string(i);
    table.channelOf({i % 256, sender(1), name, i % 3 != 0, i % 5 == 0});
  }
  EXPECT_LE(table.channels().size(), 65'000U);
}

}  // namespace
}  // namespace rocinante
