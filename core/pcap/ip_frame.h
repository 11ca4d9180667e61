#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/bytes.h"
#include "core/net/endpoint.h"

namespace rocinante {

/// The header before the IP packet in a captured frame.
enum class LinkType {
  ethernet,       ///< with up to four VLAN tags
  bsd_null,       ///< four bytes of address family, in the capturing machine's byte order
  bsd_loop,       ///< the same, in network order
  raw_ip,         ///< nothing
  linux_cooked,   ///< SLL: the type of `any`
  linux_cooked_2  ///< SLL2
};

/// The LinkType of a pcap link type (DLT_ or LINKTYPE_ number); empty when it is none of these.
std::optional<LinkType> linkTypeOf(int number);
/// As libpcap knows it (DLT_).
int linkTypeNumber(LinkType link);

/// What a frame holds that is not UDP: an EtherType, or with kIpv4Protocol or kIpv6Protocol added
/// the number of an IP protocol.
using FrameProtocol = std::uint32_t;
inline constexpr FrameProtocol kIpv4Protocol = 0x10000, kIpv6Protocol = 0x20000;
inline constexpr FrameProtocol kNotIp = 0x30000, kManyTags = 0x30001;

/// "TCP", "ARP", "EtherType 0x88b5".
std::string nameOf(FrameProtocol protocol);

/// A UDP packet in a frame, or a fragment of one.
struct IpFrame {
  SocketAddress source, destination;  ///< without ports
  std::uint32_t link = 0;             ///< the VLAN tags, 0: none
  unsigned tags = 0;                  ///< VLAN tags in front of the IP header
  std::size_t header_at = 0;          ///< offset of the IP header in the frame
  ByteView payload;                   ///< of the IP packet, as much as was captured
  bool cut = false;                   ///< the capture did not keep all of it
  bool extended = false;              ///< IPv6 extension headers precede the payload
  bool is_fragment = false;
  std::uint32_t fragment_id = 0;
  std::uint32_t fragment_offset = 0;  ///< in bytes
  bool more_fragments = false;
  unsigned next_header = 17;  ///< of a fragment's payload: 17 is UDP, else an extension header
  FrameProtocol other = 0;    ///< with FrameKind::other: which
};

enum class FrameKind {
  udp,
  other,     ///< another protocol
  malformed  ///< breaks the rules of its own headers
};

/// Reads Ethernet (IEEE 802.1Q), IPv4 (RFC 791) and IPv6 (RFC 8200) headers. Fills `result` when
/// the answer is udp; its payload points into the frame.
FrameKind readIpFrame(LinkType link, ByteView frame, IpFrame& result);

/// Skips the extension headers in `frame.payload`, that of an IPv6 packet which was put together:
/// `frame.next_header` says what its payload begins with.
FrameKind skipExtensions(IpFrame& frame);

/// The header of the link alone: its bytes, and where they hold the type of what follows.
struct LinkHeader {
  std::size_t bytes = 0;
  std::optional<std::size_t> type_at;
};
LinkHeader linkHeaderOf(LinkType link);

/// A UDP datagram in the payload of an IP packet (RFC 768).
struct UdpPayload {
  std::uint16_t source_port = 0, destination_port = 0;
  ByteView bytes;
  bool cut = false;
  std::size_t surplus = 0;  ///< bytes of the IP packet behind it (UDP options, RFC 9868)
};

/// Empty when its length is wrong. `cut`: `packet` is incomplete. Checksums are not checked: a
/// sender's own machine captures before the network card fills them in.
std::optional<UdpPayload> readUdp(ByteView packet, bool is_ipv6, bool cut);

}  // namespace rocinante
