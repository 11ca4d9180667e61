#include "core/log/chunk_compressor.h"

#include <zstd.h>

#include "core/log/mcap_chunk.h"

namespace rocinante::mcap {
namespace {

/// Compressing less than this saves nothing worth the reader's time.
constexpr std::size_t kLeastToCompress = 1024;

}  // namespace

struct ChunkCompressor::Context {
  ZSTD_CCtx* zstd = ZSTD_createCCtx();
  Scratch scratch;
  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() { ZSTD_freeCCtx(zstd); }
};

ChunkCompressor::ChunkCompressor(int zstd_level) : context_(std::make_unique<Context>()) {
  ZSTD_CCtx_setParameter(context_->zstd, ZSTD_c_compressionLevel, zstd_level);
}
ChunkCompressor::~ChunkCompressor() = default;
ChunkCompressor::ChunkCompressor(ChunkCompressor&&) noexcept = default;
ChunkCompressor& ChunkCompressor::operator=(ChunkCompressor&&) noexcept = default;

ChunkCompressor::Compressed ChunkCompressor::compress(ByteView records) {
  if (records.size() < kLeastToCompress) return {"", records};
  // Room for the worst case, so that it cannot fail for want of it.
  const std::size_t bound = ZSTD_compressBound(records.size());
  std::byte* const out = context_->scratch.make(bound);
  const std::size_t made =
      ZSTD_compress2(context_->zstd, out, bound, records.data(), records.size());
  if (ZSTD_isError(made) != 0U || made > records.size() - records.size() / 50) {
    return {"", records};
  }
  return {"zstd", ByteView(out, made)};
}

}  // namespace rocinante::mcap
