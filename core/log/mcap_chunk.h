#pragma once

#include <memory>

#include "core/bytes.h"
#include "core/log/mcap_records.h"
#include "core/result.h"

namespace rocinante::mcap {

/// No chunk that claims to hold more is expanded: a few bytes of zstd can claim anything.
inline constexpr std::uint64_t kMaxChunkBytes = std::uint64_t{256} << 20U;

/// Memory that grows and is not cleared first. Contents are lost when it grows.
class Scratch {
 public:
  std::byte* make(std::size_t bytes) {
    if (bytes > capacity_) {
      bytes_ = std::make_unique_for_overwrite<std::byte[]>(bytes);
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
  /// are there. Nothing of it can be checked.
  Result<ByteView> expandCut(const Chunk& chunk, Scratch& scratch);

 private:
  struct Contexts;
  std::unique_ptr<Contexts> contexts_;
};

/// Compresses chunks with zstd, and leaves alone what it does not make at least 2 % smaller.
class ChunkCompressor {
 public:
  explicit ChunkCompressor(int zstd_level);
  ~ChunkCompressor();
  ChunkCompressor(ChunkCompressor&&) noexcept;
  ChunkCompressor& operator=(ChunkCompressor&&) noexcept;

  struct Compressed {
    std::string_view compression;  ///< "zstd", or "" where it did not pay
    ByteView records;              ///< borrowed, until the next call
  };
  Compressed compress(ByteView records);

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

}  // namespace rocinante::mcap
