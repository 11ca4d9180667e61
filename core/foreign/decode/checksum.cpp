#include "core/foreign/decode/checksum.h"

#include <array>

namespace rocinante::decode {
namespace {

/// A CRC of 16 bits whose bits go in and out least significant first.
constexpr std::array<std::uint16_t, 256> reflectedTable(std::uint16_t polynomial) {
  std::array<std::uint16_t, 256> table{};
  for (unsigned byte = 0; byte < 256; ++byte) {
    unsigned sum = byte;
    for (int bit = 0; bit < 8; ++bit) sum = (sum & 1U) != 0 ? (sum >> 1U) ^ polynomial : sum >> 1U;
    table[byte] = static_cast<std::uint16_t>(sum);
  }
  return table;
}

constexpr std::array<std::uint16_t, 256> forwardTable(std::uint16_t polynomial) {
  std::array<std::uint16_t, 256> table{};
  for (unsigned byte = 0; byte < 256; ++byte) {
    unsigned sum = byte << 8U;
    for (int bit = 0; bit < 8; ++bit) {
      sum = (sum & 0x8000U) != 0 ? (sum << 1U) ^ polynomial : sum << 1U;
    }
    table[byte] = static_cast<std::uint16_t>(sum);
  }
  return table;
}

constexpr std::array<std::uint32_t, 256> crc32Table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t sum = byte;
    for (int bit = 0; bit < 8; ++bit) sum = (sum & 1U) != 0 ? (sum >> 1U) ^ 0xEDB88320U : sum >> 1U;
    table[byte] = sum;
  }
  return table;
}

constexpr auto kCcitt = forwardTable(0x1021);
constexpr auto kMcrf4xx = reflectedTable(0x8408);
constexpr auto kModbus = reflectedTable(0xA001);
constexpr auto kCrc32 = crc32Table();

std::uint32_t begun(ChecksumKind kind) {
  switch (kind) {
    case ChecksumKind::sum8:
    case ChecksumKind::xor8:
      return 0;
    case ChecksumKind::crc32:
      return 0xFFFFFFFFU;
    default:
      return 0xFFFFU;
  }
}

std::uint32_t continued(ChecksumKind kind, std::uint32_t sum, ByteView bytes) {
  for (const std::byte each : bytes) {
    const auto byte = static_cast<std::uint32_t>(each);
    switch (kind) {
      case ChecksumKind::sum8:
        sum = (sum + byte) & 0xFFU;
        break;
      case ChecksumKind::xor8:
        sum ^= byte;
        break;
      case ChecksumKind::crc16_ccitt:
        sum = ((sum << 8U) ^ kCcitt[((sum >> 8U) ^ byte) & 0xFFU]) & 0xFFFFU;
        break;
      case ChecksumKind::crc16_modbus:
        sum = (sum >> 8U) ^ kModbus[(sum ^ byte) & 0xFFU];
        break;
      case ChecksumKind::crc16_mcrf4xx:
        sum = (sum >> 8U) ^ kMcrf4xx[(sum ^ byte) & 0xFFU];
        break;
      case ChecksumKind::crc32:
        sum = (sum >> 8U) ^ kCrc32[(sum ^ byte) & 0xFFU];
        break;
    }
  }
  return sum;
}

}  // namespace

std::size_t checksumBytes(ChecksumKind kind) {
  if (kind == ChecksumKind::sum8 || kind == ChecksumKind::xor8) return 1;
  return kind == ChecksumKind::crc32 ? 4 : 2;
}

std::uint32_t checksumOf(ChecksumKind kind, ByteView bytes, ByteView after) {
  const std::uint32_t sum = continued(kind, continued(kind, begun(kind), bytes), after);
  return kind == ChecksumKind::crc32 ? ~sum : sum;
}

std::optional<std::size_t> positionIn(std::int64_t position, std::size_t datagram_bytes) {
  const auto size = static_cast<std::int64_t>(datagram_bytes);
  const std::int64_t from_start = position < 0 ? size + position : position;
  if (from_start < 0 || from_start > size) return std::nullopt;
  return static_cast<std::size_t>(from_start);
}

bool checksumHolds(const Checksum& checksum, ByteView datagram) {
  const auto from = positionIn(checksum.from, datagram.size());
  const auto until = positionIn(checksum.until, datagram.size());
  const auto at = positionIn(checksum.at, datagram.size());
  const std::size_t bytes = checksumBytes(checksum.kind);
  if (!from || !until || !at || *from > *until || datagram.size() - *at < bytes) return false;
  std::uint32_t sent = 0;
  for (std::size_t i = 0; i < bytes; ++i) {
    const std::size_t place = checksum.little_endian ? *at + bytes - 1 - i : *at + i;
    sent = (sent << 8U) | static_cast<std::uint32_t>(datagram[place]);
  }
  return sent == checksumOf(checksum.kind, datagram.subspan(*from, *until - *from), checksum.then);
}

}  // namespace rocinante::decode
