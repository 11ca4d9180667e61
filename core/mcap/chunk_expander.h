#pragma once

#include <cstring>
#include <memory>
#include <optional>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/mcap/records.h"

namespace rocinante::mcap {

/// No chunk that claims to hold more is expanded: a few bytes of zstd can claim anything.
inline constexpr std::uint64_t kMaxChunkBytes = std::uint64_t{256} << 20U;

/// How much the compressed chunks of one file may claim together: a file of a few bytes must not
/// keep a reader busy for minutes. Chunks are asked for in the file's order.
class ExpansionBudget {
 public:
  static constexpr std::uint64_t kFreeBytes = kMaxChunkBytes;
  /// Text that repeats itself is made some 100 times smaller, a picture of one colour 1,000 times.
  static constexpr std::uint64_t kMaxGrowth = 1000;

  explicit ExpansionBudget(std::uint64_t file_bytes)
      : left_(kFreeBytes + file_bytes * kMaxGrowth) {}

  /// False when the chunk reaches beyond; what it claims is then not counted. Nor is one that is
  /// not compressed, or is refused by itself.
  bool take(const Chunk& chunk);
  /// The same for bytes that were expanded already.
  bool take(std::uint64_t bytes);
  /// The file has become longer.
  void grow(std::uint64_t file_bytes) { left_ += file_bytes * kMaxGrowth; }
  /// Why a chunk is not expanded.
  static std::string refusal();

 private:
  std::uint64_t left_;
};

/// Memory that grows and is not cleared first.
class Scratch {
 public:
  /// At least `bytes`; the contents are lost when it grows.
  std::byte* make(std::size_t bytes) {
    if (bytes > capacity_) {
      bytes_ = std::make_unique_for_overwrite<std::byte[]>(bytes);
      capacity_ = bytes;
    }
    return bytes_.get();
  }
  /// At least `bytes`, of which the first `kept` stay as they are.
  std::byte* grow(std::size_t bytes, std::size_t kept) {
    if (bytes > capacity_) {
      auto larger = std::make_unique_for_overwrite<std::byte[]>(bytes);
      if (kept > 0) std::memcpy(larger.get(), bytes_.get(), kept);
      bytes_ = std::move(larger);
      capacity_ = bytes;
    }
    return bytes_.get();
  }
  std::size_t capacity() const { return capacity_; }

 private:
  std::unique_ptr<std::byte[]> bytes_;
  std::size_t capacity_ = 0;
};

/// Expands chunks: uncompressed and zstd. One a thread. Errors say what is wrong with the chunk;
/// where it lies is for the caller to add.
class ChunkExpander {
 public:
  ChunkExpander();
  ~ChunkExpander();
  ChunkExpander(ChunkExpander&&) noexcept;
  ChunkExpander& operator=(ChunkExpander&&) noexcept;

  /// The chunk's records, their size and CRC checked: borrowed from the chunk itself or from
  /// `scratch`. damaged, or unsupported for lz4 and unknown compressions.
  Result<ByteView> expand(const Chunk& chunk, Scratch& scratch);

  /// What can still be had of a chunk whose end is missing: `chunk.records` holds the bytes that
  /// are there, `chunk.uncompressed_size` may be open (kOpenEnded). Nothing of it can be
  /// checked. Where the bytes do not go on as zstd, what came before is given.
  Result<ByteView> expandCut(const Chunk& chunk, Scratch& scratch);

 private:
  struct Contexts;
  std::unique_ptr<Contexts> contexts_;
};

/// A chunk that is not what it says.
inline Error damagedChunk(std::string what) {
  return Error{ErrorKind::damaged, std::move(what), {}};
}

/// How many of the bytes the zstd frame at their beginning takes: empty when they end before it
/// does, or begin none. Nothing is expanded.
std::optional<std::uint64_t> zstdFrameBytes(ByteView bytes);

}  // namespace rocinante::mcap
