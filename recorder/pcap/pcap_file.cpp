#include "recorder/pcap/pcap_file.h"

#include <cassert>
#include <cstdint>
#include <limits>

#include "core/foreign/bytes/little_endian.h"

namespace rocinante {
namespace {

constexpr std::uint32_t kNanosecondMagic = 0xA1B23C4D;
constexpr std::uint32_t kMaxFrameBytes = 262'144;
constexpr std::uint32_t kLinkTypeRaw = 101;
constexpr std::size_t kRecordHeadBytes = 16;
constexpr std::size_t kUdpHeadBytes = 8;
constexpr std::uint8_t kUdpProtocol = 17;
constexpr std::uint8_t kHops = 64;

/// Appends a number as IP has it: most significant byte first.
template <class T>
void appendNetwork(Bytes& out, T value) {
  for (std::size_t i = sizeof value; i-- > 0;) {
    out.push_back(static_cast<std::byte>(value >> (8 * i) & 0xFFU));
  }
}

/// The sum of the 16-bit words (RFC 1071), an odd byte padded with zero.
std::uint64_t wordSum(ByteView bytes) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    sum += std::to_integer<std::uint64_t>(bytes[i]) << 8U;
    if (i + 1 < bytes.size()) sum += std::to_integer<std::uint64_t>(bytes[i + 1]);
  }
  return sum;
}

std::uint16_t checksumOf(std::uint64_t sum) {
  while (sum >> 16U != 0) sum = (sum & 0xFFFFU) + (sum >> 16U);
  return static_cast<std::uint16_t>(~sum);
}

void setNetwork(Bytes& bytes, std::size_t at, std::uint16_t value) {
  bytes[at] = static_cast<std::byte>(value >> 8U);
  bytes[at + 1] = static_cast<std::byte>(value & 0xFFU);
}

void appendAddress(Bytes& out, const SocketAddress& address) {
  const std::size_t bytes = address.is_ipv6 ? 16 : 4;
  appendBytes(out, std::as_bytes(std::span(address.address).first(bytes)));
}

}  // namespace

Status PcapFile::begin() {
  Bytes head;
  appendLittle(head, kNanosecondMagic);
  appendLittle(head, std::uint16_t{2});
  appendLittle(head, std::uint16_t{4});
  appendLittle(head, std::int32_t{0});   // UTC
  appendLittle(head, std::uint32_t{0});  // accuracy: not told
  appendLittle(head, kMaxFrameBytes);
  appendLittle(head, kLinkTypeRaw);
  return append_(head);
}

Status PcapFile::write(LogTime time, const SocketAddress& from, const SocketAddress& to,
                       ByteView datagram) {
  assert(from.is_ipv6 == to.is_ipv6 && datagram.size() <= kMaxPcapDatagramBytes);
  constexpr std::int64_t kNanoseconds = 1'000'000'000;
  const std::int64_t moment = nanosecondsOf(time);
  if (moment < 0 || moment / kNanoseconds > std::numeric_limits<std::uint32_t>::max()) {
    return Error{ErrorKind::unsupported, "a capture file has times of 1970 to 2106 only", {}};
  }
  const auto udp_bytes = static_cast<std::uint16_t>(kUdpHeadBytes + datagram.size());
  const std::size_t ip_head_bytes = from.is_ipv6 ? 40 : 20;
  const auto frame_bytes = static_cast<std::uint32_t>(ip_head_bytes + udp_bytes);
  frame_.clear();
  appendLittle(frame_, static_cast<std::uint32_t>(moment / kNanoseconds));
  appendLittle(frame_, static_cast<std::uint32_t>(moment % kNanoseconds));
  appendLittle(frame_, frame_bytes);
  appendLittle(frame_, frame_bytes);
  if (from.is_ipv6) {
    appendNetwork(frame_, std::uint32_t{6} << 28U);
    appendNetwork(frame_, udp_bytes);
    appendNetwork(frame_, kUdpProtocol);
    appendNetwork(frame_, kHops);
  } else {
    appendNetwork(frame_, std::uint16_t{0x4500});
    appendNetwork(frame_, static_cast<std::uint16_t>(frame_bytes));
    appendNetwork(frame_, std::uint32_t{0});  // not a fragment
    appendNetwork(frame_, kHops);
    appendNetwork(frame_, kUdpProtocol);
    appendNetwork(frame_, std::uint16_t{0});  // the checksum, below
  }
  const std::size_t addresses_at = frame_.size();
  appendAddress(frame_, from);
  appendAddress(frame_, to);
  if (!from.is_ipv6) {
    setNetwork(frame_, kRecordHeadBytes + 10,
               checksumOf(wordSum(ByteView(frame_).subspan(kRecordHeadBytes, ip_head_bytes))));
  }
  const std::size_t udp_at = frame_.size();
  // The checksum covers the addresses, the protocol and the length, too.
  const std::uint64_t pseudo =
      wordSum(ByteView(frame_).subspan(addresses_at)) + kUdpProtocol + udp_bytes;
  appendNetwork(frame_, from.port);
  appendNetwork(frame_, to.port);
  appendNetwork(frame_, udp_bytes);
  appendNetwork(frame_, std::uint16_t{0});
  appendBytes(frame_, datagram);
  const std::uint16_t checksum = checksumOf(pseudo + wordSum(ByteView(frame_).subspan(udp_at)));
  // Zero means that there is none.
  setNetwork(frame_, udp_at + 6, checksum == 0 ? std::uint16_t{0xFFFF} : checksum);
  return append_(frame_);
}

}  // namespace rocinante
