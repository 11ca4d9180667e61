#pragma once

#include <memory>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante::mcap {

/// Compresses whole chunks with zstd, and leaves alone what it does not make at least 2 % smaller.
class ChunkCompressor {
 public:
  explicit ChunkCompressor(int zstd_level);
  ~ChunkCompressor();
  ChunkCompressor(ChunkCompressor&&) noexcept;
  ChunkCompressor& operator=(ChunkCompressor&&) noexcept;

  /// Appends the records to `out` as a zstd frame; false, and `out` as it was, where that does not
  /// pay.
  bool compressInto(ByteView records, Bytes& out);

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

/// One zstd frame after another, each made piece by piece, without content size and checksum.
class FrameStream {
 public:
  FrameStream();
  ~FrameStream();
  FrameStream(FrameStream&&) noexcept;
  FrameStream& operator=(FrameStream&&) noexcept;

  /// The next frame, whatever became of the last. Not more than about `frame_bytes` go into it.
  void begin(int zstd_level, std::size_t frame_bytes);
  enum class Until { flushed, ended };
  /// Appends to `out` the bytes that carry the frame on, so that all of `records` can be expanded
  /// from what stands there. Fails only for want of memory; then the frame can only be ended by
  /// kEnd.
  Status add(ByteView records, Until until, Bytes& out);

  /// Ends a frame whose last addition was flushed: an empty last block.
  static constexpr unsigned char kEnd[3] = {1, 0, 0};

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

}  // namespace rocinante::mcap
