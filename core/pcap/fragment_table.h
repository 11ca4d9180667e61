#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <optional>

#include "core/base/bytes.h"
#include "core/base/time.h"
#include "core/net/endpoint.h"

namespace rocinante {

/// One fragment of an IP packet that holds UDP.
struct Fragment {
  SocketAddress source, destination;  ///< ports are ignored: only the first fragment has them
  std::uint32_t id = 0;
  std::uint32_t link = 0;    ///< VLAN: the same addresses may exist on several
  std::uint32_t offset = 0;  ///< in bytes, in the packet's payload
  bool more = false;         ///< more fragments follow
  WallTime time{};
  ByteView bytes;
};

/// Reassembles the fragments of IP packets (RFC 791, RFC 8200 section 4.5), in any order. A
/// repeated fragment counts once; fragments that contradict each other invalidate the packet (RFC
/// 5722). Memory and waiting time are bounded for any input. Pure: times come with the fragments,
/// and may go back.
class FragmentTable {
 public:
  struct Limits {
    std::size_t bytes = std::size_t{16} << 20U;  ///< of waiting fragments, with their overhead
    std::size_t packets = 4'096;
    Nanoseconds patience = std::chrono::seconds(2);  ///< since a packet's latest fragment
  };
  enum class Outcome { waiting, whole, malformed };

  FragmentTable() : FragmentTable(Limits()) {}
  explicit FragmentTable(Limits limits) : limits_(limits) {}

  /// `whole` when this was the last missing fragment: whole() then has the payload. `malformed`
  /// when the fragment is impossible: it is dropped.
  Outcome add(const Fragment& fragment);
  /// The payload reassembled last; valid until the next add().
  ByteView whole() const { return whole_; }

  /// Gives up the packets still waiting: at the end of a capture.
  void clear();

  /// Packets given up: with missing or contradictory fragments, or for lack of room.
  std::uint64_t incomplete() const { return incomplete_; }
  std::size_t waiting() const { return packets_.size(); }
  /// Counted like Limits::bytes.
  std::size_t bytesHeld() const { return bytes_held_; }

 private:
  // Addresses, id, link and family, concatenated.
  using Key = std::array<std::uint8_t, 41>;
  struct Packet {
    Key key{};
    WallTime latest{};
    bool given_up = false;  ///< contradictory: its further fragments are ignored
    std::optional<std::uint32_t> total;
    std::uint32_t received = 0;
    std::map<std::uint32_t, Bytes> pieces;  ///< by offset; they do not overlap
  };
  using Place = std::list<Packet>::iterator;

  static Key keyOf(const Fragment& fragment);
  Packet& packetFor(const Fragment& fragment);
  void forgetOld(WallTime now);
  void makeRoom(std::size_t bytes);
  void drop(Place packet);
  void giveUp(Packet& packet);
  void releasePieces(Packet& packet);
  void assemble(Packet& packet);

  Limits limits_;
  std::list<Packet> packets_;  ///< front: the one with the oldest latest fragment
  std::map<Key, Place> by_key_;
  std::size_t bytes_held_ = 0;
  std::uint64_t incomplete_ = 0;
  Bytes whole_;
};

}  // namespace rocinante
