#pragma once

#include <cstdint>
#include <optional>

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

/// A UDP packet in a frame, or a fragment of one.
struct IpFrame {
  SocketAddress source, destination;  ///< without ports
  std::uint32_t link = 0;             ///< the VLAN tags, 0: none
  std::size_t header_at = 0;          ///< offset of the IP header in the frame
  ByteView payload;                   ///< of the IP packet, as much as was captured
  bool cut = false;                   ///< the capture did not keep all of it
  bool is_fragment = false;
  std::uint32_t fragment_id = 0;
  std::uint32_t fragment_offset = 0;  ///< in bytes
  bool more_fragments = false;
};

enum class FrameKind {
  udp,
  other,     ///< another protocol
  malformed  ///< breaks the rules of its own headers
};

/// Reads Ethernet (IEEE 802.1Q), IPv4 (RFC 791) and IPv6 (RFC 8200) headers. Fills `result` when
/// the answer is udp; its payload points into the frame.
FrameKind readIpFrame(LinkType link, ByteView frame, IpFrame& result);

/// A UDP datagram in the payload of an IP packet (RFC 768).
struct UdpPayload {
  std::uint16_t source_port = 0, destination_port = 0;
  ByteView bytes;
  bool cut = false;
};

/// Empty when its length is wrong. `cut`: `packet` is incomplete. Checksums are not checked: a
/// sender's own machine captures before the network card fills them in.
std::optional<UdpPayload> readUdp(ByteView packet, bool is_ipv6, bool cut);

}  // namespace rocinante
