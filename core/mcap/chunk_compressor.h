#pragma once

#include <memory>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante::mcap {

/// Compresses whole chunks with zstd; leaves a chunk uncompressed when it would not become at least
/// 2 % smaller.
class ChunkCompressor {
 public:
  explicit ChunkCompressor(int zstd_level);
  ~ChunkCompressor();
  ChunkCompressor(ChunkCompressor&&) noexcept;
  ChunkCompressor& operator=(ChunkCompressor&&) noexcept;

  /// Appends the records to `out` as a zstd frame; false, with `out` unchanged, when that does not
  /// save enough.
  bool compressInto(ByteView records, Bytes& out);

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

/// Writes one zstd frame after another, each piece by piece, without content size and checksum.
class FrameStream {
 public:
  FrameStream();
  ~FrameStream();
  FrameStream(FrameStream&&) noexcept;
  FrameStream& operator=(FrameStream&&) noexcept;

  /// Begins the next frame, whatever happened to the last. At most about `frame_bytes` go into it.
  void begin(int zstd_level, std::size_t frame_bytes);
  enum class Until { flushed, ended };
  /// Appends to `out` the bytes that continue the frame, so that all of `records` can be expanded
  /// from the bytes written so far. Fails only for lack of memory; then the frame can only be ended
  /// by kEnd.
  Status add(ByteView records, Until until, Bytes& out);

  /// Ends a frame whose last addition was flushed: an empty last block.
  static constexpr unsigned char kEnd[3] = {1, 0, 0};

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

}  // namespace rocinante::mcap
