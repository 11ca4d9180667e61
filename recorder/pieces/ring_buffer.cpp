#include "recorder/pieces/ring_buffer.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace rocinante {
namespace {

constexpr std::uint64_t kFewestBlocks = 4;
constexpr std::size_t kAlignment = 8;

}  // namespace

RingBuffer::RingBuffer(std::uint64_t max_bytes)
    : max_blocks_(std::max(kFewestBlocks, max_bytes / kBlockBytes)) {}

std::size_t RingBuffer::spaceFor(std::size_t bytes) {
  return (sizeof(Header) + bytes + kAlignment - 1) / kAlignment * kAlignment;
}

bool RingBuffer::startBlock() {
  if (empty()) {
    while (!blocks_.empty()) dropFrontBlock();
  }
  if (blocks_.size() == max_blocks_) return false;
  if (spare_) {
    blocks_.push_back({std::move(spare_), 0});
  } else {
    blocks_.push_back({std::make_unique_for_overwrite<std::byte[]>(kBlockBytes), 0});
  }
  next_.block = first_block_ + blocks_.size() - 1;
  next_.offset = 0;
  return true;
}

void RingBuffer::dropFrontBlock() {
  spare_ = std::move(blocks_.front().bytes);
  blocks_.pop_front();
  ++first_block_;
  front_offset_ = 0;
}

bool RingBuffer::add(const Item& item) {
  const std::size_t space = spaceFor(item.payload.size() + item.made.size());
  assert(space <= kBlockBytes);
  assert(item.made.size() <= std::numeric_limits<std::uint16_t>::max());
  if (blocks_.empty() || kBlockBytes - blocks_.back().used < space) {
    if (!startBlock()) return false;
  }
  Block& block = blocks_.back();
  const Header header{item.time.time_since_epoch().count(),
                      item.publish_time_ns,
                      item.flow,
                      item.sequence,
                      item.kind,
                      item.decoder,
                      static_cast<std::uint16_t>(item.made.size()),
                      static_cast<std::uint32_t>(item.payload.size())};
  std::byte* const at = block.bytes.get() + block.used;
  std::memcpy(at, &header, sizeof header);
  if (!item.payload.empty()) {
    std::memcpy(at + sizeof header, item.payload.data(), item.payload.size());
  }
  if (!item.made.empty()) {
    std::memcpy(at + sizeof header + item.payload.size(), item.made.data(), item.made.size());
  }
  block.used += static_cast<std::uint32_t>(space);
  ++next_.number;
  next_.offset = block.used;
  return true;
}

/// The same place, normalised: a block's end becomes the beginning of the next block.
RingBuffer::Place RingBuffer::found(const Place& place) const {
  if (place.number == first_) return begin();
  const Block& block = blocks_[place.block - first_block_];
  if (place.offset < block.used) return place;
  return {place.number, place.block + 1, 0};
}

RingBuffer::Header RingBuffer::headerAt(const Place& place) const {
  assert(place.number >= first_ && place.number < next_.number);
  Header header{};
  std::memcpy(&header, blocks_[place.block - first_block_].bytes.get() + place.offset,
              sizeof header);
  return header;
}

RingBuffer::Item RingBuffer::at(const Place& place) const {
  const Place there = found(place);
  const Header header = headerAt(there);
  const std::byte* const payload =
      blocks_[there.block - first_block_].bytes.get() + there.offset + sizeof header;
  return {header.kind,
          LogTime(Nanoseconds(header.time_ns)),
          header.publish_time_ns,
          header.flow,
          header.sequence,
          {payload, header.payload_bytes},
          {payload + header.payload_bytes, header.made_bytes},
          header.decoder};
}

RingBuffer::Place RingBuffer::after(const Place& place) const {
  const Place there = found(place);
  const Header header = headerAt(there);
  return {place.number + 1, there.block,
          there.offset + static_cast<std::uint32_t>(
                             spaceFor(std::size_t{header.payload_bytes} + header.made_bytes))};
}

void RingBuffer::popFront() {
  const Place next = after(begin());
  first_ = next.number;
  front_offset_ = next.offset;
  if (front_offset_ == blocks_.front().used && blocks_.size() > 1) dropFrontBlock();
}

}  // namespace rocinante
