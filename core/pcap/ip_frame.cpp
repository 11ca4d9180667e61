#include "core/pcap/ip_frame.h"

#include <algorithm>

namespace rocinante {
namespace {

constexpr unsigned kIpv4 = 0x0800;
constexpr unsigned kIpv6 = 0x86DD;
constexpr unsigned kUdp = 17;
constexpr int kMaxTags = 4;
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
std::optional<unsigned> readLink(LinkType link, Cursor& at, std::uint32_t& tags) {
  const auto take = [&](std::size_t header, std::size_t type) -> std::optional<unsigned> {
    if (!at.has(header)) return std::nullopt;
    const unsigned value = at.two(type);
    at.skip(header);
    return value;
  };
  std::optional<unsigned> type;
  switch (link) {
    case LinkType::ethernet:
      type = take(14, 12);
      break;
    case LinkType::linux_cooked:
      type = take(16, 14);
      break;
    case LinkType::linux_cooked_2:
      type = take(20, 0);
      break;
    case LinkType::bsd_null:
    case LinkType::bsd_loop:
    case LinkType::raw_ip: {
      if (link != LinkType::raw_ip) {
        if (!at.has(4)) return std::nullopt;
        at.skip(4);  // address families differ between systems; the IP version does not
      }
      if (!at.has(1)) return std::nullopt;
      const unsigned version = at.byte(0) >> 4U;
      return version == 4 ? kIpv4 : version == 6 ? kIpv6 : 0;
    }
  }
  for (int tag = 0; type && (*type == 0x8100 || *type == 0x88A8 || *type == 0x9100); ++tag) {
    if (tag == kMaxTags) return 0;
    if (!at.has(4)) return std::nullopt;
    tags = tags << 12U | (at.two(0) & 0x0FFFU);
    type = take(4, 2);
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
  if (at.byte(9) != kUdp) return FrameKind::other;
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

FrameKind readIpv6(Cursor at, IpFrame& result) {
  if (!at.has(40) || at.byte(0) >> 4U != 6) return FrameKind::malformed;
  result.source = at.address(8, true);
  result.destination = at.address(24, true);
  unsigned next = at.byte(6);
  std::size_t left = at.two(4);
  at.skip(40);
  for (int extension = 0; next != kUdp; ++extension) {
    const bool is_fragment = next == 44;
    if (next != 0 && next != 43 && next != 60 && !is_fragment) return FrameKind::other;
    if (extension == kMaxExtensions || !at.has(8)) return FrameKind::malformed;
    const std::size_t length = is_fragment ? 8 : (std::size_t{at.byte(1)} + 1) * 8;
    if (length > left || !at.has(length)) return FrameKind::malformed;
    next = at.byte(0);
    if (is_fragment) {
      const unsigned flags = at.two(2);
      result.more_fragments = (flags & 1U) != 0;
      result.fragment_offset = flags & 0xFFF8U;
      result.is_fragment = result.more_fragments || result.fragment_offset != 0;
      result.fragment_id = at.four(4);
      if (next != kUdp) return FrameKind::other;
    }
    at.skip(length);
    left -= length;
  }
  takePayload(at, left, result);
  return FrameKind::udp;
}

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

FrameKind readIpFrame(LinkType link, ByteView frame, IpFrame& result) {
  result = {};
  Cursor at(frame);
  const auto type = readLink(link, at, result.link);
  if (!type) return FrameKind::malformed;
  result.header_at = frame.size() - at.rest().size();
  if (*type == kIpv4) return readIpv4(at, result);
  if (*type == kIpv6) return readIpv6(at, result);
  return FrameKind::other;
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
  udp.bytes = packet.subspan(8, std::min(length, packet.size()) - 8);
  return udp;
}

}  // namespace rocinante
