#include "core/mcap/open_chunk_stream.h"

#include <fmt/format.h>
#include <zstd.h>

#include <algorithm>

#include "core/base/hash.h"
#include "core/mcap/chunk_expander.h"

namespace rocinante::mcap {
namespace {

constexpr std::size_t kPieceBytes = 1U << 17U;

}  // namespace

struct OpenChunkStream::Impl {
  Impl() : zstd(ZSTD_createDCtx()), piece(kPieceBytes) {}
  ~Impl() { ZSTD_freeDCtx(zstd); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  ZSTD_DCtx* zstd;
  Bytes piece;
  bool ended = false;
  /// Expanded and not returned yet; the bytes before `at` were returned.
  Bytes pending;
  std::size_t at = 0;
  std::uint64_t given_bytes = 0;  ///< of records, before pending[at]
  std::uint64_t expanded_bytes = 0;
  std::uint32_t crc = 0;

  void drop() {
    pending.erase(pending.begin(), pending.begin() + static_cast<std::ptrdiff_t>(at));
    at = 0;
  }

  Status keep(ByteView bytes) {
    expanded_bytes += bytes.size();
    if (expanded_bytes > kMaxChunkBytes) {
      return damagedChunk(fmt::format("the chunk expands to more than {} bytes", kMaxChunkBytes));
    }
    crc = crc32(bytes, crc);
    pending.insert(pending.end(), bytes.begin(), bytes.end());
    return {};
  }
};

OpenChunkStream::OpenChunkStream() : impl_(std::make_unique<Impl>()) {}
OpenChunkStream::~OpenChunkStream() = default;
OpenChunkStream::OpenChunkStream(OpenChunkStream&&) noexcept = default;
OpenChunkStream& OpenChunkStream::operator=(OpenChunkStream&&) noexcept = default;

void OpenChunkStream::begin() {
  Impl& chunk = *impl_;
  chunk.ended = false;
  chunk.pending.clear();
  chunk.at = 0;
  chunk.given_bytes = chunk.expanded_bytes = 0;
  chunk.crc = 0;
  ZSTD_DCtx_reset(chunk.zstd, ZSTD_reset_session_only);
}

Result<std::size_t> OpenChunkStream::feed(ByteView stored) {
  Impl& chunk = *impl_;
  chunk.drop();
  ZSTD_inBuffer in{stored.data(), stored.size(), 0};
  while (!chunk.ended) {
    ZSTD_outBuffer out{chunk.piece.data(), chunk.piece.size(), 0};
    const std::size_t hint = ZSTD_decompressStream(chunk.zstd, &out, &in);
    if (ZSTD_isError(hint) != 0U) {
      return damagedChunk(
          fmt::format("the chunk does not decompress: {}", ZSTD_getErrorName(hint)));
    }
    if (Status kept = chunk.keep(ByteView(chunk.piece).first(out.pos)); !kept) return kept.error();
    chunk.ended = hint == 0;
    // A full output piece may have left more in the decompressor.
    if (in.pos == in.size && out.pos < out.size) break;
  }
  return in.pos;
}

Result<std::optional<Record>> OpenChunkStream::next() {
  Impl& chunk = *impl_;
  const ByteView rest = ByteView(chunk.pending).subspan(chunk.at);
  std::optional<Record> record = recordAt(rest, 0);
  if (!record) {
    if (chunk.ended && !rest.empty()) return damagedChunk("the chunk ends inside a record");
    if (rest.size() >= kPrefixBytes) {
      std::uint64_t length = 0;
      std::memcpy(&length, rest.data() + 1, sizeof(length));
      if (length > kMaxChunkBytes) {
        return damagedChunk(fmt::format("the chunk claims a record of {} bytes", length));
      }
    }
    return std::optional<Record>();
  }
  record->offset = chunk.given_bytes;
  const std::size_t size = kPrefixBytes + record->content.size();
  chunk.at += size;
  chunk.given_bytes += size;
  return record;
}

bool OpenChunkStream::ended() const { return impl_->ended; }
std::uint64_t OpenChunkStream::expandedBytes() const { return impl_->expanded_bytes; }
std::uint32_t OpenChunkStream::crc() const { return impl_->crc; }

}  // namespace rocinante::mcap
