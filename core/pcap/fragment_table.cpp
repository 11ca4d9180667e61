#include "core/pcap/fragment_table.h"

#include <algorithm>
#include <iterator>

namespace rocinante {
namespace {

// No IP packet is longer, whatever its fragments claim.
constexpr std::uint32_t kMaxPayload = 65'535;
// The overhead of keeping a piece, or a packet, in addition to its bytes.
constexpr std::size_t kPieceCost = 96;
constexpr std::size_t kPacketCost = 256;

enum class Fit { missing, known, contradicts };

/// Whether `bytes` at `offset` are new to `pieces`, a repetition, or contradictory.
Fit fitOf(const std::map<std::uint32_t, Bytes>& pieces, std::uint32_t offset, ByteView bytes) {
  const auto end = static_cast<std::uint32_t>(offset + bytes.size());
  auto piece = pieces.upper_bound(offset);
  if (piece != pieces.begin()) {
    const auto before = std::prev(piece);
    if (before->first + before->second.size() > offset) piece = before;
  }
  if (piece == pieces.end() || piece->first >= end) return Fit::missing;
  // They overlap: every byte must already be there, and equal.
  for (std::uint32_t at = offset; at < end; ++piece) {
    if (piece == pieces.end() || piece->first > at) return Fit::contradicts;
    const auto piece_end = static_cast<std::uint32_t>(piece->first + piece->second.size());
    const std::uint32_t until = std::min(piece_end, end);
    if (!std::equal(bytes.begin() + (at - offset), bytes.begin() + (until - offset),
                    piece->second.begin() + (at - piece->first))) {
      return Fit::contradicts;
    }
    at = until;
  }
  return Fit::known;
}

}  // namespace

FragmentTable::Key FragmentTable::keyOf(const Fragment& fragment) {
  Key key{};
  auto at = std::copy(fragment.source.address.begin(), fragment.source.address.end(), key.begin());
  at = std::copy(fragment.destination.address.begin(), fragment.destination.address.end(), at);
  for (const std::uint32_t number : {fragment.id, fragment.link}) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
      *at++ = static_cast<std::uint8_t>(number >> shift);
    }
  }
  *at = fragment.source.is_ipv6 ? 1 : 0;
  return key;
}

FragmentTable::Outcome FragmentTable::add(const Fragment& fragment) {
  forgetOld(fragment.time);
  const std::size_t size = fragment.bytes.size();
  if (size == 0 || size > kMaxPayload || fragment.offset > kMaxPayload - size) {
    return Outcome::malformed;
  }
  if (fragment.offset % 8 != 0 || (fragment.more && size % 8 != 0)) return Outcome::malformed;

  Packet& packet = packetFor(fragment);
  if (packet.given_up) return Outcome::waiting;
  const auto end = static_cast<std::uint32_t>(fragment.offset + size);
  const bool beyond_the_end =
      packet.total && (end > *packet.total || (!fragment.more && end != *packet.total));
  const bool ends_too_early =
      !fragment.more && !packet.pieces.empty() &&
      packet.pieces.rbegin()->first + packet.pieces.rbegin()->second.size() > end;
  const Fit fit = fitOf(packet.pieces, fragment.offset, fragment.bytes);
  if (beyond_the_end || ends_too_early || fit == Fit::contradicts) {
    giveUp(packet);
    return Outcome::waiting;
  }
  if (!fragment.more) packet.total = end;
  if (fit == Fit::missing) {
    packet.pieces.emplace(fragment.offset, Bytes(fragment.bytes.begin(), fragment.bytes.end()));
    packet.received += static_cast<std::uint32_t>(size);
    bytes_held_ += size + kPieceCost;
    makeRoom(0);
  }
  if (packet.total != packet.received) return Outcome::waiting;
  assemble(packet);
  return Outcome::whole;
}

/// The packet, moved to the back as the one with the newest fragment.
FragmentTable::Packet& FragmentTable::packetFor(const Fragment& fragment) {
  const Key key = keyOf(fragment);
  if (const auto known = by_key_.find(key); known != by_key_.end()) {
    packets_.splice(packets_.end(), packets_, known->second);
  } else {
    makeRoom(kPacketCost);
    Packet packet;
    packet.key = key;
    packets_.push_back(std::move(packet));
    by_key_.emplace(key, std::prev(packets_.end()));
    bytes_held_ += kPacketCost;
  }
  packets_.back().latest = fragment.time;
  return packets_.back();
}

void FragmentTable::forgetOld(WallTime now) {
  // After a clock was set back, packets from the future count as old.
  while (!packets_.empty() && std::chrono::abs(now - packets_.front().latest) > limits_.patience) {
    drop(packets_.begin());
  }
}

/// For a new packet, or for the bytes that the newest one just took: the newest stays.
void FragmentTable::makeRoom(std::size_t bytes) {
  const std::size_t keep = bytes > 0 ? 0 : 1;
  while (packets_.size() > keep &&
         (bytes_held_ + bytes > limits_.bytes || packets_.size() + 1 - keep > limits_.packets)) {
    drop(packets_.begin());
  }
}

void FragmentTable::releasePieces(Packet& packet) {
  bytes_held_ -= packet.received + packet.pieces.size() * kPieceCost;
  packet.pieces.clear();
  packet.received = 0;
}

void FragmentTable::giveUp(Packet& packet) {
  releasePieces(packet);
  packet.given_up = true;
  ++incomplete_;
}

void FragmentTable::drop(Place packet) {
  if (!packet->given_up) ++incomplete_;
  releasePieces(*packet);
  bytes_held_ -= kPacketCost;
  by_key_.erase(packet->key);
  packets_.erase(packet);
}

void FragmentTable::assemble(Packet& packet) {
  whole_.clear();
  for (const auto& [offset, bytes] : packet.pieces) {
    whole_.insert(whole_.end(), bytes.begin(), bytes.end());
  }
  packet.given_up = true;  // so that drop() does not count it as incomplete
  drop(by_key_.at(packet.key));
}

void FragmentTable::clear() {
  while (!packets_.empty()) drop(packets_.begin());
}

}  // namespace rocinante
