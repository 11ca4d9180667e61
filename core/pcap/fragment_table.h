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
  SocketAddress source, destination;  ///< ports do not count: only the first fragment has them
  std::uint32_t id = 0;
  std::uint32_t link = 0;    ///< VLAN: the same addresses may live on several
  std::uint32_t offset = 0;  ///< in bytes, of the packet's payload
  bool more = false;         ///< not the last
  WallTime time{};
  ByteView bytes;
};

/// Puts the fragments of IP packets together (RFC 791, RFC 8200 section 4.5), in any order. The
/// same fragment twice is once; fragments that contradict each other make the packet nothing
/// (RFC 5722). Memory and patience are bounded, whatever is sent. Pure: times come with the
/// fragments, and may go back.
class FragmentTable {
 public:
  struct Limits {
    std::size_t bytes = std::size_t{16} << 20U;  ///< of what waits, with what it takes to keep it
    std::size_t packets = 4'096;
    Nanoseconds patience = std::chrono::seconds(2);  ///< since a packet's latest fragment
  };
  enum class Outcome { waiting, whole, malformed };

  FragmentTable() : FragmentTable(Limits()) {}
  explicit FragmentTable(Limits limits) : limits_(limits) {}

  /// `whole` when this was the last that was missing: then whole() has it. `malformed` when no
  /// fragment can be so: it is left out.
  Outcome add(const Fragment& fragment);
  /// The payload put together last; valid until the next add().
  ByteView whole() const { return whole_; }

  /// Gives up what still waits: at the end of a capture.
  void clear();

  /// Packets given up: fragments never came, contradict each other, or there was no room.
  std::uint64_t incomplete() const { return incomplete_; }
  std::size_t waiting() const { return packets_.size(); }
  /// As counted against Limits::bytes.
  std::size_t bytesHeld() const { return bytes_held_; }

 private:
  // Addresses, id, link and family, one after the other.
  using Key = std::array<std::uint8_t, 41>;
  struct Packet {
    Key key{};
    WallTime latest{};
    bool given_up = false;  ///< contradicted: what still comes of it is ignored
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
  std::list<Packet> packets_;  ///< the one whose latest fragment is oldest in front
  std::map<Key, Place> by_key_;
  std::size_t bytes_held_ = 0;
  std::uint64_t incomplete_ = 0;
  Bytes whole_;
};

}  // namespace rocinante
