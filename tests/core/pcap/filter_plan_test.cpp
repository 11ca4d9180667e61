// No filter in front of the reader is narrower than the reader (docs/decisions/035).
#include <gtest/gtest.h>

#include <functional>

#include "core/pcap/pcap_filter.h"
#include "tests/core/pcap/frames.h"

namespace rocinante {
namespace {

using test::FrameBytes;
using test::ipPackets;
using test::Sent;
using test::sent;
using test::udpOf;

constexpr WallTime kPlanTime{std::chrono::seconds(1'700'000'000)};
constexpr std::array kLinks = {LinkType::ethernet,     LinkType::bsd_null,
                               LinkType::bsd_loop,     LinkType::raw_ip,
                               LinkType::linux_cooked, LinkType::linux_cooked_2};

Bytes onLink(LinkType link, const Bytes& packet, const std::vector<unsigned>& tags) {
  const bool is_ipv6 = std::to_integer<unsigned>(packet.at(0)) >> 4U == 6;
  const unsigned type = is_ipv6 ? 0x86DD : 0x0800;
  // 802.1ad outside, 802.1Q inside
  const unsigned outer = tags.size() > 1 ? 0x88A8 : 0x8100;
  const unsigned first = tags.empty() ? type : outer;
  FrameBytes frame;
  switch (link) {
    case LinkType::ethernet:
      frame.number(0x020000000001, 6).number(0x020000000002, 6).number(first, 2);
      break;
    case LinkType::linux_cooked:
      frame.number(4, 2).number(1, 2).number(6, 2).number(0, 8).number(first, 2);
      break;
    case LinkType::linux_cooked_2:
      frame.number(first, 2).number(0, 2).number(3, 4).number(1, 2).number(4, 1).number(6, 1);
      frame.number(0, 8);
      break;
    case LinkType::bsd_null:
      frame.number(is_ipv6 ? 0x0A000000 : 0x02000000, 4);
      break;
    case LinkType::bsd_loop:
      frame.number(is_ipv6 ? 10 : 2, 4);
      break;
    case LinkType::raw_ip:
      break;
  }
  for (std::size_t i = 0; i < tags.size(); ++i) {
    frame.number(tags[i], 2).number(i + 1 < tags.size() ? 0x8100 : type, 2);
  }
  return frame.bytes(packet).take();
}

Bytes withOptions(const Sent& datagram) {
  const Bytes udp = udpOf(datagram);
  FrameBytes packet;
  packet.number(0x47, 1).number(0, 1).number(28 + udp.size(), 2).number(7, 2).number(0, 2);
  packet.number(64, 1).number(17, 1).number(0, 2).address(datagram.from).address(datagram.to);
  return packet.number(0x9404000001010100, 8).bytes(udp).take();
}

/// With extension headers of these types in front.
Bytes extended(const Sent& datagram, const std::vector<unsigned>& types) {
  const Bytes udp = udpOf(datagram);
  FrameBytes packet;
  packet.number(0x60000000, 4).number(8 * types.size() + udp.size(), 2);
  packet.number(types.front(), 1).number(64, 1).address(datagram.from).address(datagram.to);
  for (std::size_t i = 0; i < types.size(); ++i) {
    packet.number(i + 1 < types.size() ? types[i + 1] : 17, 1).number(0, 1);
    packet.number(types[i] == 44 ? 0 : 0x0104, 2).number(0, 4);
  }
  return packet.bytes(udp).take();
}

/// One frame or several for each way in which the reader knows a datagram.
std::vector<std::pair<std::string, std::vector<Bytes>>> packetsOf(const Sent& datagram) {
  std::vector<std::pair<std::string, std::vector<Bytes>>> packets{
      {"plain", ipPackets(datagram)}, {"fragments", ipPackets(datagram, 16)}};
  if (!datagram.from.is_ipv6) {
    packets.push_back({"options", {withOptions(datagram)}});
  } else {
    for (const std::vector<unsigned>& types :
         {std::vector<unsigned>{0}, {43}, {60}, {44}, {0, 60, 43, 44, 60}}) {
      packets.push_back({"extensions", {extended(datagram, types)}});
    }
  }
  return packets;
}

const std::vector<std::vector<unsigned>> kTags = {{}, {5}, {5, 6}};

using PlanTexts = std::vector<std::string>;

PlanTexts readBy(FrameReader& reader, LinkType link, const std::vector<Bytes>& frames,
                 const std::function<bool(ByteView)>& passes) {
  PlanTexts seen;
  for (const Bytes& frame : frames) {
    if (!passes(frame)) continue;
    if (const auto datagram = reader.read(link, frame, kPlanTime)) {
      seen.push_back(datagram->destination.text() + " " + std::string(textOf(datagram->payload)));
    }
  }
  return seen;
}

TEST(FilterPlan, PassesEveryFrameThatTheReaderKnows) {
  const std::string payload = "a payload of more than sixteen bytes";
  for (const LinkType link : kLinks) {
    const bool has_tags = linkHeaderOf(link).type_at.has_value();
    for (const std::string filter : {"", "udp port 5000", "dst port 5000 and not src port 9",
                                     "not port 6000", "ip or ip6", "vlan", "not vlan 7"}) {
      if (namesTags(filter) && link != LinkType::ethernet) continue;
      SCOPED_TRACE(std::to_string(linkTypeNumber(link)) + " " + filter);
      const FilterPlan plan = planFilter(filter);
      const auto kernel = compiledFilter(plan.kernel, link);
      ASSERT_TRUE(kernel.ok()) << kernel.error().text();
      FrameReader::Filter asked;
      if (!filter.empty()) asked = *compiledFilter(filter, link);
      for (const std::uint16_t port : {std::uint16_t{5000}, std::uint16_t{6000}}) {
        const bool is_chosen =
            filter.find("5000") == filter.npos && filter.find("6000") == filter.npos ? true
                                                                                     : port == 5000;
        for (const Sent& datagram : {sent("10.0.0.1", 4'000, "10.0.0.2", port, payload),
                                     sent("fd00::1", 4'000, "fd00::2", port, payload)}) {
          for (const auto& [name, packets] : packetsOf(datagram)) {
            for (const std::vector<unsigned>& tags : kTags) {
              if (!has_tags && !tags.empty()) continue;
              SCOPED_TRACE(name + " " + datagram.from.text() + " tags " +
                           std::to_string(tags.size()) + " to " + std::to_string(port));
              std::vector<Bytes> frames;
              for (const Bytes& packet : packets) frames.push_back(onLink(link, packet, tags));
              FrameReader unfiltered;
              const PlanTexts all = readBy(unfiltered, link, frames, [](ByteView) { return true; });
              ASSERT_EQ(all, PlanTexts{datagram.to.text() + " " + payload});
              FrameReader reader(asked, plan.filtered, plan.keep_tags);
              const PlanTexts taken = readBy(
                  reader, link, frames, [&](ByteView frame) { return (*kernel)(link, frame); });
              const bool wants = filter == "vlan" ? !tags.empty() : is_chosen;
              EXPECT_EQ(taken, wants ? all : PlanTexts{});
              // A file is not filtered before it is read, and the outcome is the same.
              FrameReader of_file(asked, FrameReader::Filtered::here, plan.keep_tags);
              EXPECT_EQ(readBy(of_file, link, frames, [](ByteView) { return true; }), taken);
              EXPECT_EQ(of_file.leftOut(true).total(), wants ? 0U : 1U);
            }
          }
        }
      }
    }
  }
}

TEST(FilterPlan, StopsWhatNoReaderUses) {
  const auto kernel = compiledFilter(planFilter("").kernel, LinkType::ethernet);
  ASSERT_TRUE(kernel.ok());
  for (const Sent& datagram :
       {sent("10.0.0.1", 1, "10.0.0.2", 2, "x"), sent("fd00::1", 1, "fd00::2", 2, "x")}) {
    Bytes tcp = ipPackets(datagram).at(0);
    tcp[datagram.from.is_ipv6 ? 6 : 9] = std::byte{6};
    EXPECT_FALSE((*kernel)(LinkType::ethernet, onLink(LinkType::ethernet, tcp, {})));
  }
}

}  // namespace
}  // namespace rocinante
