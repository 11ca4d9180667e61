#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/net/endpoint.h"

namespace rocinante::test {

/// Makes frames as on a wire, for tests of their readers. Numbers in network order.
class FrameBytes {
 public:
  FrameBytes& number(std::uint64_t value, unsigned bytes) {
    for (unsigned at = bytes; at-- > 0;) {
      bytes_.push_back(at < 8 ? static_cast<std::byte>(value >> at * 8) : std::byte{0});
    }
    return *this;
  }
  FrameBytes& bytes(ByteView more) {
    bytes_.insert(bytes_.end(), more.begin(), more.end());
    return *this;
  }
  FrameBytes& address(const SocketAddress& address) {
    for (unsigned i = 0; i < (address.is_ipv6 ? 16U : 4U); ++i) number(address.address[i], 1);
    return *this;
  }
  Bytes take() { return std::move(bytes_); }

 private:
  Bytes bytes_;
};

struct Sent {
  SocketAddress from, to;
  std::string payload;
};

inline Sent sent(std::string_view from, std::uint16_t from_port, std::string_view to,
                 std::uint16_t to_port, std::string payload) {
  return {SocketAddress::parse(from, from_port).value(), SocketAddress::parse(to, to_port).value(),
          std::move(payload)};
}

inline Bytes udpOf(const Sent& datagram) {
  return FrameBytes()
      .number(datagram.from.port, 2)
      .number(datagram.to.port, 2)
      .number(8 + datagram.payload.size(), 2)
      .number(0, 2)  // no checksum
      .bytes(bytesOf(datagram.payload))
      .take();
}

/// One IP packet with a payload that may be a part: `offset` in bytes.
inline Bytes ipPacket(const Sent& datagram, ByteView part, std::uint32_t id, std::size_t offset,
                      bool more) {
  FrameBytes packet;
  if (!datagram.from.is_ipv6) {
    packet.number(0x45, 1).number(0, 1).number(20 + part.size(), 2).number(id, 2);
    packet.number((more ? 0x2000U : 0U) | offset / 8, 2).number(64, 1).number(17, 1).number(0, 2);
    packet.address(datagram.from).address(datagram.to);
  } else {
    const bool fragment = more || offset > 0;
    packet.number(0x60000000, 4).number(part.size() + (fragment ? 8 : 0), 2);
    packet.number(fragment ? 44 : 17, 1).number(64, 1);
    packet.address(datagram.from).address(datagram.to);
    if (fragment)
      packet.number(17, 1).number(0, 1).number(offset | (more ? 1U : 0U), 2).number(id, 4);
  }
  return packet.bytes(part).take();
}

/// The packets of one datagram: one, or fragments with at most `most` bytes of payload each.
inline std::vector<Bytes> ipPackets(const Sent& datagram, std::size_t most = 65'535,
                                    std::uint32_t id = 7) {
  const Bytes udp = udpOf(datagram);
  std::vector<Bytes> packets;
  const std::size_t step = most / 8 * 8;
  for (std::size_t offset = 0; offset < udp.size(); offset += step) {
    const std::size_t size = std::min(step, udp.size() - offset);
    packets.push_back(ipPacket(datagram, ByteView(udp).subspan(offset, size), id, offset,
                               offset + size < udp.size()));
  }
  return packets;
}

/// A frame with VLAN tags, outermost first.
inline Bytes ethernetFrame(const Bytes& packet, const std::vector<unsigned>& vlans = {}) {
  FrameBytes frame;
  frame.number(0x020000000001, 6).number(0x020000000002, 6);
  for (const unsigned vlan : vlans) frame.number(0x8100, 2).number(vlan, 2);
  const bool is_ipv6 = std::to_integer<unsigned>(packet.at(0)) >> 4U == 6;
  return frame.number(is_ipv6 ? 0x86DD : 0x0800, 2).bytes(packet).take();
}

}  // namespace rocinante::test
