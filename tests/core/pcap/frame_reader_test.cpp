#include "core/pcap/frame_reader.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/pcap/frames.h"

namespace rocinante {
namespace {

using test::ethernetFrame;
using test::FrameBytes;
using test::ipPacket;
using test::ipPackets;
using test::Sent;
using test::sent;
using test::udpOf;

constexpr WallTime kTime{std::chrono::seconds(1'700'000'000)};

const Sent kIpv4 = sent("10.0.0.1", 4'000, "10.0.0.2", 5'000, "hello");
const Sent kIpv6 = sent("fd00::1", 4'000, "ff15::7", 5'000, "hello");

/// A datagram captured unfragmented.
void expectSeen(FrameReader& reader, ByteView frame, const Sent& expected,
                LinkType link = LinkType::ethernet) {
  const auto seen = reader.read(link, frame, kTime);
  ASSERT_TRUE(seen.has_value());
  EXPECT_EQ(seen->sender, expected.from);
  EXPECT_EQ(seen->destination, expected.to);
  EXPECT_EQ(textOf(seen->payload), expected.payload);
  EXPECT_FALSE(seen->cut);
}

TEST(FrameReader, ReadsEveryKindOfLink) {
  for (const Sent& datagram : {kIpv4, kIpv6}) {
    const bool is_ipv6 = datagram.from.is_ipv6;
    const Bytes packet = ipPackets(datagram).at(0);
    const unsigned type = is_ipv6 ? 0x86DD : 0x0800;
    const std::vector<std::pair<LinkType, Bytes>> frames{
        {LinkType::ethernet, ethernetFrame(packet)},
        {LinkType::ethernet, ethernetFrame(packet, {7})},
        {LinkType::ethernet, ethernetFrame(packet, {1, 2, 3, 4})},
        // The family in little-endian order, and in big-endian order.
        {LinkType::bsd_null,
         FrameBytes().number(is_ipv6 ? 0x1E000000 : 0x02000000, 4).bytes(packet).take()},
        {LinkType::bsd_null, FrameBytes().number(is_ipv6 ? 10 : 2, 4).bytes(packet).take()},
        {LinkType::bsd_loop, FrameBytes().number(is_ipv6 ? 24 : 2, 4).bytes(packet).take()},
        {LinkType::raw_ip, packet},
        // packet type, ARPHRD, address length, address, protocol
        {LinkType::linux_cooked, FrameBytes()
                                     .number(4, 2)
                                     .number(1, 2)
                                     .number(6, 2)
                                     .number(0, 8)
                                     .number(type, 2)
                                     .bytes(packet)
                                     .take()},
        // protocol, reserved, interface, ARPHRD, packet type, address length, address
        {LinkType::linux_cooked_2, FrameBytes()
                                       .number(type, 2)
                                       .number(0, 2)
                                       .number(3, 4)
                                       .number(1, 2)
                                       .number(4, 1)
                                       .number(6, 1)
                                       .number(0, 8)
                                       .bytes(packet)
                                       .take()},
    };
    for (const auto& [link, frame] : frames) {
      SCOPED_TRACE(static_cast<int>(link));
      FrameReader reader;
      expectSeen(reader, frame, datagram, link);
      EXPECT_EQ(reader.counts(), InputCounts());
    }
  }
}

TEST(FrameReader, PaddingIsNoPayload) {
  Bytes frame = ethernetFrame(ipPackets(kIpv4).at(0));
  frame.resize(60, std::byte{0xEE});
  FrameReader reader;
  expectSeen(reader, frame, kIpv4);
}

TEST(FrameReader, PutsFragmentsTogetherOverBothVersionsOfIp) {
  for (Sent datagram : {kIpv4, kIpv6}) {
    datagram.payload.assign(65'000, 'x');
    for (std::size_t i = 0; i < datagram.payload.size(); ++i) {
      datagram.payload[i] = static_cast<char>(i * 7 / 3);
    }
    FrameReader reader;
    std::vector<Bytes> packets = ipPackets(datagram, 1'480);
    ASSERT_GT(packets.size(), 40U);
    std::swap(packets.front(), packets[3]);
    for (std::size_t i = 0; i + 1 < packets.size(); ++i) {
      EXPECT_FALSE(
          reader.read(LinkType::ethernet, ethernetFrame(packets[i], {9}), kTime).has_value());
    }
    expectSeen(reader, ethernetFrame(packets.back(), {9}), datagram);
    EXPECT_EQ(reader.counts(), InputCounts());
  }
}

TEST(FrameReader, SkipsExtensionHeadersOfIpv6) {
  const Bytes udp = udpOf(kIpv6);
  FrameBytes packet;
  packet.number(0x60000000, 4).number(8 + 16 + 8 + udp.size(), 2).number(0, 1).number(64, 1);
  packet.address(kIpv6.from).address(kIpv6.to);
  packet.number(60, 1).number(0, 1).number(0, 6);               // hop-by-hop
  packet.number(44, 1).number(1, 1).number(0, 14);              // destination options
  packet.number(17, 1).number(0, 1).number(0, 2).number(9, 4);  // an atomic fragment
  FrameReader reader;
  expectSeen(reader, packet.bytes(udp).take(), kIpv6, LinkType::raw_ip);
}

TEST(FrameReader, CountsWhatIsNoUdpAndWhatBreaksTheRules) {
  FrameReader reader;
  Bytes tcp = ipPackets(kIpv4).at(0);
  tcp[9] = std::byte{6};
  EXPECT_FALSE(reader.read(LinkType::ethernet, ethernetFrame(tcp), kTime).has_value());
  const Bytes arp = FrameBytes().number(0, 12).number(0x0806, 2).number(0, 28).take();
  EXPECT_FALSE(reader.read(LinkType::ethernet, arp, kTime).has_value());
  EXPECT_EQ(reader.counts().other, 2U);

  Bytes short_udp = ipPackets(kIpv4).at(0);
  short_udp[25] = std::byte{7};
  Bytes long_udp = ipPackets(kIpv4).at(0);
  long_udp[25] = std::byte{99};
  Bytes long_header = ipPackets(kIpv4).at(0);
  long_header[0] = std::byte{0x4F};
  Bytes short_total = ipPackets(kIpv4).at(0);
  short_total[3] = std::byte{19};
  for (const Bytes& each : {short_udp, long_udp, long_header, short_total}) {
    EXPECT_FALSE(reader.read(LinkType::ethernet, ethernetFrame(each), kTime).has_value());
  }
  EXPECT_EQ(reader.counts().malformed, 4U);
  std::vector<std::string> left_out;
  const Account account = reader.leftOut(true);
  for (const LeftOut& each : account.leftOut()) left_out.push_back(each.text());
  EXPECT_EQ(left_out,
            (std::vector<std::string>{
                "1 frame `ARP` (not UDP; at frame 2)", "1 frame `TCP` (not UDP; at frame 1)",
                "4 frames `malformed` (breaks the rules of IP or UDP; the first at frame 3)"}));
}

TEST(FrameReader, NamesEveryProtocolThatItPassesOver) {
  EXPECT_EQ(nameOf(0x88A4), "EtherCAT");
  EXPECT_EQ(nameOf(0x0026), "IEEE 802.3");
  EXPECT_EQ(nameOf(0x88B5), "EtherType 0x88b5");
  EXPECT_EQ(nameOf(kIpv4Protocol + 1), "ICMP");
  EXPECT_EQ(nameOf(kIpv6Protocol + 200), "IP protocol 200");
  EXPECT_EQ(nameOf(kNotIp), "neither IPv4 nor IPv6");
}

TEST(FrameReader, PutsExtensionHeadersBehindAFragmentHeaderTogether) {
  // The destination options are in the part that is cut into fragments (RFC 8200, section 4.1).
  FrameBytes whole;
  whole.number(17, 1).number(1, 1).number(0, 14).bytes(udpOf(kIpv6));
  const Bytes part = whole.take();
  FrameReader reader;
  std::optional<SeenDatagram> seen;
  for (std::size_t offset = 0; offset < part.size(); offset += 16) {
    const std::size_t size = std::min<std::size_t>(16, part.size() - offset);
    const bool more = offset + size < part.size();
    FrameBytes packet;
    packet.number(0x60000000, 4).number(8 + size, 2).number(44, 1).number(64, 1);
    packet.address(kIpv6.from).address(kIpv6.to);
    packet.number(60, 1).number(0, 1).number(offset | (more ? 1U : 0U), 2).number(77, 4);
    packet.bytes(ByteView(part).subspan(offset, size));
    seen = reader.read(LinkType::raw_ip, packet.take(), kTime);
    EXPECT_EQ(seen.has_value(), !more);
  }
  ASSERT_TRUE(seen.has_value());
  EXPECT_EQ(textOf(seen->payload), kIpv6.payload);
  EXPECT_EQ(seen->destination, kIpv6.to);
  EXPECT_TRUE(reader.leftOut(true).empty());
}

TEST(FrameReader, BytesBehindADatagramAreNamed) {
  Bytes packet = ipPackets(kIpv4).at(0);
  packet.insert(packet.end(), 6, std::byte{7});
  packet[3] = static_cast<std::byte>(std::to_integer<unsigned>(packet[3]) + 6);
  FrameReader reader;
  expectSeen(reader, ethernetFrame(packet), kIpv4);
  const Account account = reader.leftOut(true);
  ASSERT_EQ(account.total(), 1U);
  EXPECT_EQ(account.leftOut()[0].name, "UDP options");
}

TEST(FrameReader, WhatTheCaptureCutIsMarked) {
  const Bytes frame = ethernetFrame(ipPackets(kIpv4).at(0));
  FrameReader reader;
  for (std::size_t size = 0; size < frame.size(); ++size) {
    // A buffer of exactly this size, so that a sanitizer sees one byte too many.
    const Bytes part(frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(size));
    const auto seen = reader.read(LinkType::ethernet, part, frame.size(), kTime);
    const std::size_t headers = 14 + 20 + 8;
    ASSERT_EQ(seen.has_value(), size >= headers) << size;
    if (!seen) continue;
    EXPECT_TRUE(seen->cut);
    EXPECT_EQ(textOf(seen->payload), kIpv4.payload.substr(0, size - headers));
  }
}

TEST(FrameReader, AFilterWithPortsTakesAllFragmentsOfItsDatagrams) {
  Sent wanted = kIpv4;
  Sent other = sent("10.0.0.1", 4'000, "10.0.0.2", 6'000, "");
  wanted.payload.assign(5'000, 'w');
  other.payload.assign(5'000, 'o');
  // Like libpcap's `port 5000`: no fragment has ports.
  const auto filter = [](LinkType, ByteView frame) {
    const bool whole = (std::to_integer<unsigned>(frame[20]) & 0x3FU) == 0 &&
                       std::to_integer<unsigned>(frame[21]) == 0;
    return whole && frame[36] == std::byte{5'000 >> 8} && frame[37] == std::byte{5'000 & 255};
  };
  for (const auto filtered : {FrameReader::Filtered::before, FrameReader::Filtered::here}) {
    FrameReader reader(filter, filtered, false);
    int seen = 0;
    const auto wanted_packets = ipPackets(wanted, 1'480, 1);
    const auto other_packets = ipPackets(other, 1'480, 2);
    for (std::size_t i = 0; i < wanted_packets.size(); ++i) {
      for (const auto& packets : {wanted_packets, other_packets}) {
        const auto datagram = reader.read(LinkType::ethernet, ethernetFrame(packets[i]), kTime);
        if (!datagram) continue;
        ++seen;
        EXPECT_EQ(textOf(datagram->payload), wanted.payload);
      }
    }
    EXPECT_EQ(seen, 1);
    // Whole datagrams arrive filtered, or are checked here.
    const Bytes whole = ethernetFrame(ipPackets(sent("10.0.0.1", 1, "10.0.0.2", 2, "x")).at(0));
    EXPECT_EQ(reader.read(LinkType::ethernet, whole, kTime).has_value(),
              filtered == FrameReader::Filtered::before);
  }
}

/// Bytes of every kind: nothing crashes, and no result is longer than a datagram.
TEST(FrameReader, AnyBytesAreReadOrCounted) {
  std::mt19937 random(1'996);
  Sent large = kIpv6;
  large.payload.assign(4'000, 'x');
  std::vector<Bytes> seeds{ethernetFrame(ipPackets(kIpv4).at(0)),
                           ethernetFrame(ipPackets(kIpv6).at(0))};
  for (const Bytes& each : ipPackets(large, 1'000)) seeds.push_back(ethernetFrame(each, {1}));
  FrameReader reader;
  for (int round = 0; round < 60'000; ++round) {
    Bytes frame = seeds[random() % seeds.size()];
    for (unsigned change = 0; change < random() % 4; ++change) {
      frame[random() % std::min<std::size_t>(frame.size(), 70)] = static_cast<std::byte>(random());
    }
    if (random() % 4 == 0) frame.resize(random() % frame.size());
    const auto seen =
        reader.read(LinkType::ethernet, frame, kTime + std::chrono::milliseconds(round));
    if (seen) {
      ASSERT_LE(seen->payload.size(), 65'527U);
    }
  }
  EXPECT_GT(reader.counts().malformed, 0U);
  EXPECT_GT(reader.counts().other, 0U);
}

}  // namespace
}  // namespace rocinante
