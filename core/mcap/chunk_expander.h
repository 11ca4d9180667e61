#pragma once

#include <cstring>
#include <memory>
#include <optional>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/mcap/records.h"

namespace rocinante::mcap {

/// Chunks that claim more are not expanded: a few bytes of zstd can claim any size.
inline constexpr std::uint64_t kMaxChunkBytes = std::uint64_t{256} << 20U;

/// Limits what the compressed chunks of one file may claim together: a file of a few bytes must not
/// keep a reader busy for minutes. Chunks must be submitted in the file's order.
class ExpansionBudget {
 public:
  static constexpr std::uint64_t kFreeBytes = kMaxChunkBytes;
  /// Repetitive text compresses about 100 times, a picture of one colour 1,000 times.
  static constexpr std::uint64_t kMaxGrowth = 1000;

  explicit ExpansionBudget(std::uint64_t file_bytes)
      : left_(kFreeBytes + file_bytes * kMaxGrowth) {}

  /// False when the chunk exceeds the budget; its claim is then not counted. An uncompressed chunk,
  /// or one refused for its own sake, is not counted either.
  bool take(const Chunk& chunk);
  /// The same for bytes already expanded.
  bool take(std::uint64_t bytes);
  /// Adds to the budget: the file has become longer.
  void grow(std::uint64_t file_bytes) { left_ += file_bytes * kMaxGrowth; }
  /// The reason for a refusal.
  static std::string refusal();

 private:
  std::uint64_t left_;
};

/// Memory that grows without being cleared.
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
  /// At least `bytes`; the first `kept` bytes are preserved.
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

/// Expands chunks: uncompressed, zstd, and lz4 where the build has it. One per thread. Errors
/// describe the fault of the chunk; the caller adds its position.
class ChunkExpander {
 public:
  ChunkExpander();
  ~ChunkExpander();
  ChunkExpander(ChunkExpander&&) noexcept;
  ChunkExpander& operator=(ChunkExpander&&) noexcept;

  /// The chunk's records with their size and CRC checked, borrowed from the chunk itself or from
  /// `scratch`. damaged, or unsupported for unknown compressions.
  Result<ByteView> expand(const Chunk& chunk, Scratch& scratch);

  /// Expands what is left of a chunk whose end is missing: `chunk.records` holds the remaining
  /// bytes, `chunk.uncompressed_size` may be kOpenEnded. Nothing can be checked. Where the bytes
  /// stop being valid zstd, the records before that are returned.
  Result<ByteView> expandCut(const Chunk& chunk, Scratch& scratch);

 private:
  struct Contexts;
  std::unique_ptr<Contexts> contexts_;
};

/// The error for a chunk that contradicts itself.
inline Error damagedChunk(std::string what) {
  return Error{ErrorKind::damaged, std::move(what), {}};
}

/// The number of bytes of the zstd frame at the front: empty when they end inside the frame, or do
/// not begin one. Expands nothing.
std::optional<std::uint64_t> zstdFrameBytes(ByteView bytes);

/// The size that the zstd frame at the front claims to expand to: empty when its head is cut or
/// does not state it. Expands nothing.
std::optional<std::uint64_t> zstdContentBytes(ByteView bytes);

}  // namespace rocinante::mcap
