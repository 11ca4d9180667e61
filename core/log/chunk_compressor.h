#pragma once

#include <memory>
#include <string_view>

#include "core/bytes.h"

namespace rocinante::mcap {

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
