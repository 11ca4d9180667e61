#pragma once

#include <cstdint>
#include <cstring>
#include <deque>
#include <memory>

#include "core/base/bytes.h"
#include "core/base/time.h"

namespace rocinante {

/// The items of a recording (datagrams, losses, clock steps) in memory of fixed size, oldest first.
/// Items are removed at the front and added at the end. Pure.
class RingBuffer {
 public:
  enum class Kind : std::uint8_t { datagram, loss, step };

  struct Item {
    Kind kind = Kind::datagram;
    LogTime time{};  ///< never goes back
    std::int64_t publish_time_ns = 0;
    std::uint32_t flow = 0;
    std::uint32_t sequence = 0;
    ByteView payload;  ///< borrowed until the item is removed, as is the next
    /// The packet that a decoder made of a datagram, and the decoder's number; empty: none.
    ByteView made{};  ///< at most 65,535 bytes
    std::uint8_t decoder = 0;
  };

  /// A place between two items. Invalid once it lies before the front.
  struct Place {
    std::uint64_t number = 0;  ///< of the next item, counted from the first ever added
    std::uint64_t block = 0;   ///< counted likewise
    std::uint32_t offset = 0;
    bool operator==(const Place& other) const { return number == other.number; }
  };

  static constexpr std::size_t kBlockBytes = std::size_t{1} << 20U;

  /// Uses at least four blocks, so that any datagram fits and dropping a block loses little.
  explicit RingBuffer(std::uint64_t max_bytes);

  /// False when it does not fit: remove items at the front first.
  bool add(const Item& item);
  /// The first item. Not for an empty ring.
  Item front() const { return at(begin()); }
  void popFront();

  bool empty() const { return first_ == next_.number; }
  std::uint64_t size() const { return next_.number - first_; }
  /// Memory of the blocks in use.
  std::uint64_t bytes() const { return blocks_.size() * kBlockBytes; }
  std::uint64_t maxBytes() const { return max_blocks_ * kBlockBytes; }

  Place begin() const { return {first_, first_block_, front_offset_}; }
  Place end() const { return next_; }
  /// The item after `place`, which is not the end.
  Item at(const Place& place) const;
  Place after(const Place& place) const;

 private:
  struct Header {
    std::int64_t time_ns;
    std::int64_t publish_time_ns;
    std::uint32_t flow;
    std::uint32_t sequence;
    Kind kind;
    std::uint8_t decoder;
    std::uint16_t made_bytes;
    std::uint32_t payload_bytes;
  };
  struct Block {
    std::unique_ptr<std::byte[]> bytes;
    std::uint32_t used = 0;
  };

  static std::size_t spaceFor(std::size_t bytes);
  Header headerAt(const Place& place) const;
  Place found(const Place& place) const;
  bool startBlock();
  void dropFrontBlock();

  std::uint64_t max_blocks_;
  std::deque<Block> blocks_;
  std::unique_ptr<std::byte[]> spare_;  ///< avoids allocation while the ring turns
  std::uint64_t first_block_ = 0;       ///< number of blocks_.front()
  std::uint32_t front_offset_ = 0;
  std::uint64_t first_ = 0;  ///< number of the first item
  Place next_;
};

}  // namespace rocinante
