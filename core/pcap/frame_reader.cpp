#include "core/pcap/frame_reader.h"

#include <algorithm>

namespace rocinante {

std::optional<SeenDatagram> FrameReader::read(ByteView frame, WallTime time) {
  switch (readIpFrame(link_, frame, ip_)) {
    case FrameKind::other:
      ++counts_.other;
      return std::nullopt;
    case FrameKind::malformed:
      ++counts_.malformed;
      return std::nullopt;
    case FrameKind::udp:
      break;
  }
  if (ip_.is_fragment) {
    const Fragment fragment{ip_.source, ip_.destination,     ip_.fragment_id,
                            ip_.link,   ip_.fragment_offset, ip_.more_fragments,
                            time,       ip_.payload};
    // The missing bytes of a cut fragment cannot be known.
    const auto outcome = ip_.cut ? FragmentTable::Outcome::malformed : fragments_.add(fragment);
    if (outcome == FragmentTable::Outcome::malformed) ++counts_.malformed;
    if (outcome != FragmentTable::Outcome::whole) return std::nullopt;
    ip_.payload = fragments_.whole();
    if (filter_ && !filter_(withoutFragments(frame))) return std::nullopt;
  } else if (filtered_ == Filtered::here && !wants(frame)) {
    return std::nullopt;
  }
  const auto udp = readUdp(ip_.payload, ip_.source.is_ipv6, ip_.cut);
  if (!udp) {
    ++counts_.malformed;
    return std::nullopt;
  }
  SeenDatagram seen{ip_.source, ip_.destination, udp->bytes, udp->cut};
  seen.sender.port = udp->source_port;
  seen.destination.port = udp->destination_port;
  return seen;
}

/// The frame of the last fragment, as if the datagram had not been fragmented.
ByteView FrameReader::withoutFragments(ByteView frame) {
  const bool is_ipv6 = ip_.source.is_ipv6;
  const std::size_t header = is_ipv6 ? 40 : 20;
  const ByteView before = frame.first(ip_.header_at + header);
  rebuilt_.assign(before.begin(), before.end());
  rebuilt_.insert(rebuilt_.end(), ip_.payload.begin(), ip_.payload.end());
  const std::size_t length =
      std::min<std::size_t>(ip_.payload.size() + (is_ipv6 ? 0 : header), 65'535);
  const auto set = [&](std::size_t at, std::size_t value) {
    rebuilt_[ip_.header_at + at] = static_cast<std::byte>(value & 0xFFU);
  };
  const std::size_t length_at = is_ipv6 ? 4 : 2;
  set(length_at, length >> 8U);
  set(length_at + 1, length);
  if (is_ipv6) {
    set(6, 17);  // UDP comes next
  } else {
    set(0, 0x45);  // without options
    set(6, 0);
    set(7, 0);
  }
  return rebuilt_;
}

InputCounts FrameReader::counts() const {
  InputCounts counts = counts_;
  counts.incomplete = fragments_.incomplete();
  return counts;
}

}  // namespace rocinante
