#include "core/pcap/ip_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

namespace rocinante {
namespace {

constexpr unsigned kIpv4 = 0x0800;
constexpr unsigned kIpv6 = 0x86DD;
constexpr unsigned kUdp = 17;
constexpr unsigned kMaxTags = 4;
// Hop-by-hop, destination, routing: a packet has a few, a hostile one as many as fit.
constexpr int kMaxExtensions = 8;

/// Reads numbers in network order and never past the end.
class Cursor {
 public:
  explicit Cursor(ByteView bytes) : bytes_(bytes) {}

  bool has(std::size_t count) const { return bytes_.size() >= count; }
  /// Read at `offset` from here; the caller has checked has().
  unsigned byte(std::size_t offset) const { return std::to_integer<unsigned>(bytes_[offset]); }
  unsigned two(std::size_t offset) const { return byte(offset) << 8U | byte(offset + 1); }
  std::uint32_t four(std::size_t offset) const { return two(offset) << 16U | two(offset + 2); }
  void skip(std::size_t count) { bytes_ = bytes_.subspan(count); }
  ByteView rest() const { return bytes_; }

  SocketAddress address(std::size_t offset, bool is_ipv6) const {
    SocketAddress address;
    address.is_ipv6 = is_ipv6;
    const ByteView part = bytes_.subspan(offset, is_ipv6 ? 16 : 4);
    std::transform(part.begin(), part.end(), address.address.begin(),
                   [](std::byte each) { return std::to_integer<std::uint8_t>(each); });
    return address;
  }

 private:
  ByteView bytes_;
};

/// The EtherType of the frame's contents; empty when the frame ends before it. Leaves the cursor
/// after the link's header.
std::optional<FrameProtocol> readLink(LinkType link, Cursor& at, IpFrame& result) {
  const LinkHeader header = linkHeaderOf(link);
  if (!at.has(header.bytes)) return std::nullopt;
  if (!header.type_at) {
    // Address families differ between systems; the IP version does not.
    at.skip(header.bytes);
    if (!at.has(1)) return std::nullopt;
    const unsigned version = at.byte(0) >> 4U;
    return version == 4 ? kIpv4 : version == 6 ? kIpv6 : kNotIp;
  }
  unsigned type = at.two(*header.type_at);
  at.skip(header.bytes);
  while (type == 0x8100 || type == 0x88A8 || type == 0x9100) {
    if (result.tags == kMaxTags) return kManyTags;
    if (!at.has(4)) return std::nullopt;
    result.link = result.link << 12U | (at.two(0) & 0x0FFFU);
    type = at.two(2);
    at.skip(4);
    ++result.tags;
  }
  return type;
}

/// Takes `length` bytes of payload, or as many as were captured.
void takePayload(const Cursor& at, std::size_t length, IpFrame& result) {
  result.cut = !at.has(length);
  result.payload = at.rest().first(std::min(length, at.rest().size()));
}

FrameKind readIpv4(Cursor at, IpFrame& result) {
  if (!at.has(20)) return FrameKind::malformed;
  const std::size_t header = std::size_t{at.byte(0) & 0x0FU} * 4;
  if (at.byte(0) >> 4U != 4 || header < 20) return FrameKind::malformed;
  if (at.byte(9) != kUdp) {
    result.other = kIpv4Protocol + at.byte(9);
    return FrameKind::other;
  }
  std::size_t total = at.two(2);
  // Segmentation offload: the network card fills in the length.
  if (total == 0) total = at.rest().size();
  if (total < header || !at.has(header)) return FrameKind::malformed;
  const unsigned flags = at.two(6);
  result.source = at.address(12, false);
  result.destination = at.address(16, false);
  result.more_fragments = (flags & 0x2000U) != 0;
  result.fragment_offset = (flags & 0x1FFFU) * 8;
  result.is_fragment = result.more_fragments || result.fragment_offset != 0;
  result.fragment_id = at.two(4);
  at.skip(header);
  takePayload(at, total - header, result);
  return FrameKind::udp;
}

/// Of IPv6: what precedes UDP, `left` bytes of which belong to the packet. A fragment's payload is
/// taken as it is.
FrameKind readExtensions(Cursor at, std::size_t left, IpFrame& result) {
  for (int extension = 0; result.next_header != kUdp; ++extension) {
    const unsigned header = result.next_header;
    const bool is_fragment = header == 44;
    if (header != 0 && header != 43 && header != 60 && !is_fragment) {
      result.other = kIpv6Protocol + header;
      return FrameKind::other;
    }
    if (extension == kMaxExtensions || !at.has(8)) return FrameKind::malformed;
    const std::size_t length = is_fragment ? 8 : (std::size_t{at.byte(1)} + 1) * 8;
    if (length > left || !at.has(length)) return FrameKind::malformed;
    result.extended = true;
    result.next_header = at.byte(0);
    const unsigned flags = at.two(2);
    const std::uint32_t id = at.four(4);
    at.skip(length);
    left -= length;
    if (!is_fragment || (flags & 0xFFF9U) == 0) continue;  // or an atomic one
    result.is_fragment = true;
    result.more_fragments = (flags & 1U) != 0;
    result.fragment_offset = flags & 0xFFF8U;
    result.fragment_id = id;
    const unsigned next = result.next_header;
    if (next != kUdp && next != 43 && next != 60) {
      result.other = kIpv6Protocol + next;
      return FrameKind::other;
    }
    break;
  }
  takePayload(at, left, result);
  return FrameKind::udp;
}

FrameKind readIpv6(Cursor at, IpFrame& result) {
  if (!at.has(40) || at.byte(0) >> 4U != 6) return FrameKind::malformed;
  result.source = at.address(8, true);
  result.destination = at.address(24, true);
  result.next_header = at.byte(6);
  const std::size_t left = at.two(4);
  at.skip(40);
  return readExtensions(at, left, result);
}

struct NamedProtocol {
  FrameProtocol protocol;
  std::string_view name;
};
constexpr auto kEtherTypes = std::to_array<NamedProtocol>({
    {0x0806, "ARP"},
    {0x22F0, "AVTP"},
    {0x8035, "RARP"},
    {0x8137, "IPX"},
    {0x8847, "MPLS"},
    {0x8848, "MPLS"},
    {0x8863, "PPPoE"},
    {0x8864, "PPPoE"},
    {0x8892, "PROFINET"},
    {0x88A4, "EtherCAT"},
    {0x88CC, "LLDP"},
    {0x88E5, "MACsec"},
    {0x88F7, "PTP"},
    {0x8915, "RoCE"},
    {kNotIp, "neither IPv4 nor IPv6"},
    {kManyTags, "more than 4 VLAN tags"},
});
constexpr auto kIpProtocols = std::to_array<NamedProtocol>({
    {0, "hop-by-hop options"},
    {1, "ICMP"},
    {2, "IGMP"},
    {4, "IPv4 in IP"},
    {6, "TCP"},
    {41, "IPv6 in IP"},
    {47, "GRE"},
    {50, "ESP"},
    {51, "AH"},
    {58, "ICMPv6"},
    {59, "IPv6 without a payload"},
    {89, "OSPF"},
    {103, "PIM"},
    {112, "VRRP"},
    {132, "SCTP"},
    {136, "UDP-Lite"},
});

}  // namespace

std::optional<LinkType> linkTypeOf(int number) {
  switch (number) {
    case 0:
      return LinkType::bsd_null;
    case 1:
      return LinkType::ethernet;
    case 12:   // DLT_RAW
    case 14:   // DLT_RAW of OpenBSD
    case 101:  // LINKTYPE_RAW
    case 228:  // LINKTYPE_IPV4
    case 229:  // LINKTYPE_IPV6
      return LinkType::raw_ip;
    case 108:
      return LinkType::bsd_loop;
    case 113:
      return LinkType::linux_cooked;
    case 276:
      return LinkType::linux_cooked_2;
    default:
      return std::nullopt;
  }
}

int linkTypeNumber(LinkType link) {
  switch (link) {
    case LinkType::bsd_null:
      return 0;
    case LinkType::ethernet:
      return 1;
    case LinkType::raw_ip:
      return 12;
    case LinkType::bsd_loop:
      return 108;
    case LinkType::linux_cooked:
      return 113;
    case LinkType::linux_cooked_2:
      return 276;
  }
  return -1;
}

FrameKind readIpFrame(LinkType link, ByteView frame, IpFrame& result) {
  result = {};
  Cursor at(frame);
  const auto type = readLink(link, at, result);
  if (!type) return FrameKind::malformed;
  result.header_at = frame.size() - at.rest().size();
  if (*type == kIpv4) return readIpv4(at, result);
  if (*type == kIpv6) return readIpv6(at, result);
  result.other = *type;
  return FrameKind::other;
}

FrameKind skipExtensions(IpFrame& frame) {
  const Cursor at(frame.payload);
  return readExtensions(at, frame.payload.size(), frame);
}

LinkHeader linkHeaderOf(LinkType link) {
  switch (link) {
    case LinkType::ethernet:
      return {14, 12};
    case LinkType::linux_cooked:
      return {16, 14};
    case LinkType::linux_cooked_2:
      return {20, 0};
    case LinkType::bsd_null:
    case LinkType::bsd_loop:
      return {4, std::nullopt};
    case LinkType::raw_ip:
      break;
  }
  return {};
}

std::string nameOf(FrameProtocol protocol) {
  const bool is_ip = protocol >= kIpv4Protocol && protocol < kNotIp;
  const FrameProtocol number = is_ip ? protocol & 0xFFU : protocol;
  const std::span<const NamedProtocol> names =
      is_ip ? std::span<const NamedProtocol>(kIpProtocols) : kEtherTypes;
  const auto named = std::ranges::find(names, number, &NamedProtocol::protocol);
  if (named != names.end()) return std::string(named->name);
  if (is_ip) return fmt::format("IP protocol {}", number);
  if (number < 1536) return "IEEE 802.3";
  return fmt::format("EtherType {:#06x}", number);
}

std::optional<UdpPayload> readUdp(ByteView packet, bool is_ipv6, bool cut) {
  const Cursor at(packet);
  if (!at.has(8)) return std::nullopt;
  UdpPayload udp;
  udp.source_port = static_cast<std::uint16_t>(at.two(0));
  udp.destination_port = static_cast<std::uint16_t>(at.two(2));
  std::size_t length = at.two(4);
  // RFC 2675: a jumbogram, too long for the field.
  if (length == 0 && is_ipv6) length = packet.size();
  if (length < 8) return std::nullopt;
  if (length > packet.size() && !cut) return std::nullopt;
  udp.cut = length > packet.size();
  if (!udp.cut && !cut) udp.surplus = packet.size() - length;
  udp.bytes = packet.subspan(8, std::min(length, packet.size()) - 8);
  return udp;
}

}  // namespace rocinante
