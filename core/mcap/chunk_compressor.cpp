#include "core/mcap/chunk_compressor.h"

#include <fmt/format.h>
#include <zstd.h>

#include <algorithm>
#include <bit>

namespace rocinante::mcap {
namespace {

/// Saving less than this is not worth the reader's time.
constexpr std::size_t kLeastToCompress = 1024;

/// At the lowest level zstd remembers 2^14 places, a table that shares no first-level cache with
/// the bytes. Packets repeat what was said shortly before them: 2^12 places take an eighth of the
/// time less, and as a rule make smaller chunks.
constexpr int kLowestLevel = 1;
constexpr int kLowestHashLog = 12;

void setLevel(ZSTD_CCtx* zstd, int level) {
  ZSTD_CCtx_setParameter(zstd, ZSTD_c_compressionLevel, level);
  if (level == kLowestLevel) ZSTD_CCtx_setParameter(zstd, ZSTD_c_hashLog, kLowestHashLog);
}

}  // namespace

struct ChunkCompressor::Context {
  ZSTD_CCtx* zstd = ZSTD_createCCtx();
  std::unique_ptr<std::byte[]> room;  ///< for the worst case, so that it cannot fail for lack of it
  std::size_t room_bytes = 0;
  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() { ZSTD_freeCCtx(zstd); }
};

ChunkCompressor::ChunkCompressor(int zstd_level) : context_(std::make_unique<Context>()) {
  setLevel(context_->zstd, zstd_level);
}
ChunkCompressor::~ChunkCompressor() = default;
ChunkCompressor::ChunkCompressor(ChunkCompressor&&) noexcept = default;
ChunkCompressor& ChunkCompressor::operator=(ChunkCompressor&&) noexcept = default;

bool ChunkCompressor::compressInto(ByteView records, Bytes& out) {
  if (records.size() < kLeastToCompress) return false;
  Context& context = *context_;
  if (const std::size_t worst = ZSTD_compressBound(records.size()); worst > context.room_bytes) {
    context.room = std::make_unique_for_overwrite<std::byte[]>(worst);
    context.room_bytes = worst;
  }
  const std::size_t made = ZSTD_compress2(context.zstd, context.room.get(), context.room_bytes,
                                          records.data(), records.size());
  const bool pays = ZSTD_isError(made) == 0U && made <= records.size() - records.size() / 50;
  if (pays) out.insert(out.end(), context.room.get(), context.room.get() + made);
  return pays;
}

struct FrameStream::Context {
  ZSTD_CCtx* zstd = ZSTD_createCCtx();
  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() { ZSTD_freeCCtx(zstd); }
};

FrameStream::FrameStream() : context_(std::make_unique<Context>()) {}
FrameStream::~FrameStream() = default;
FrameStream::FrameStream(FrameStream&&) noexcept = default;
FrameStream& FrameStream::operator=(FrameStream&&) noexcept = default;

void FrameStream::begin(int zstd_level, std::size_t frame_bytes) {
  ZSTD_CCtx* const zstd = context_->zstd;
  ZSTD_CCtx_reset(zstd, ZSTD_reset_session_and_parameters);
  setLevel(zstd, zstd_level);
  // Without a given size, high levels use windows of 128 MiB, here and in every reader.
  const int window = std::clamp(static_cast<int>(std::bit_width(frame_bytes)), 17, 24);
  ZSTD_CCtx_setParameter(zstd, ZSTD_c_windowLog, window);
}

Status FrameStream::add(ByteView records, Until until, Bytes& out) {
  ZSTD_inBuffer in{records.data(), records.size(), 0};
  const ZSTD_EndDirective directive = until == Until::ended ? ZSTD_e_end : ZSTD_e_flush;
  std::size_t used = out.size();
  for (;;) {
    out.resize(used + ZSTD_compressBound(records.size() - in.pos) + ZSTD_CStreamOutSize());
    ZSTD_outBuffer rest{out.data() + used, out.size() - used, 0};
    const std::size_t left = ZSTD_compressStream2(context_->zstd, &rest, &in, directive);
    used += rest.pos;
    out.resize(used);
    if (ZSTD_isError(left) != 0U) {
      return Error{
          ErrorKind::refused, fmt::format("zstd cannot compress: {}", ZSTD_getErrorName(left)), {}};
    }
    if (left == 0) return {};
  }
}

}  // namespace rocinante::mcap
