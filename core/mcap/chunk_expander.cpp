#include "core/mcap/chunk_expander.h"

#include <fmt/format.h>
#include <zstd.h>

#include <algorithm>

#include "core/base/hash.h"
#include "core/mcap/lz4_frame.h"

namespace rocinante::mcap {
namespace {

/// A zstd block is at most 128 KiB and takes at least 4 bytes: no valid frame grows more.
constexpr std::uint64_t kMaxZstdGrowth = 32768;

/// The smallest size of a zstd frame's header.
constexpr std::size_t kFrameHeadBytes = 5;

/// The initial size for a chunk of unknown size.
constexpr std::size_t kFirstRoom = std::size_t{64} << 10U;

/// A sequence of LZ4 copies at most 255 bytes for each of its own.
constexpr std::uint64_t kMaxLz4Growth = 255;

bool isLz4(const Chunk& chunk) { return chunk.compression == "lz4" && canExpandLz4(); }

/// Refusals that are known before the first byte is expanded.
Status mayExpand(const Chunk& chunk) {
  if (chunk.compression != "" && chunk.compression != "zstd" && !isLz4(chunk)) {
    return Error{ErrorKind::unsupported,
                 fmt::format("the chunk is compressed with \"{}\"; only {} can be read",
                             chunk.compression.substr(0, 32),
                             canExpandLz4() ? "zstd, lz4 and none" : "zstd and none"),
                 {}};
  }
  if (chunk.uncompressed_size > kMaxChunkBytes) {
    return damagedChunk(fmt::format("the chunk claims to hold {} bytes; at most {} are expanded",
                                    chunk.uncompressed_size, kMaxChunkBytes));
  }
  return {};
}

bool claimsTooMuch(const Chunk& chunk) {
  const std::uint64_t growth = isLz4(chunk) ? kMaxLz4Growth : kMaxZstdGrowth;
  return chunk.uncompressed_size > (chunk.records.size() + 1) * growth;
}

}  // namespace

bool ExpansionBudget::take(const Chunk& chunk) {
  if (chunk.compression.empty() || !mayExpand(chunk) || claimsTooMuch(chunk)) return true;
  return take(chunk.uncompressed_size);
}

bool ExpansionBudget::take(std::uint64_t bytes) {
  if (bytes > left_) return false;
  left_ -= bytes;
  return true;
}

std::string ExpansionBudget::refusal() {
  return fmt::format(
      "the chunk is not expanded: with those before it, it claims more than {} bytes and {} times "
      "the file's size",
      kFreeBytes, kMaxGrowth);
}

struct ChunkExpander::Contexts {
  ZSTD_DCtx* zstd = ZSTD_createDCtx();
  Contexts() = default;
  Contexts(const Contexts&) = delete;
  Contexts& operator=(const Contexts&) = delete;
  ~Contexts() { ZSTD_freeDCtx(zstd); }
};

ChunkExpander::ChunkExpander() : contexts_(std::make_unique<Contexts>()) {}
ChunkExpander::~ChunkExpander() = default;
ChunkExpander::ChunkExpander(ChunkExpander&&) noexcept = default;
ChunkExpander& ChunkExpander::operator=(ChunkExpander&&) noexcept = default;

Result<ByteView> ChunkExpander::expand(const Chunk& chunk, Scratch& scratch) {
  if (Status allowed = mayExpand(chunk); !allowed) return allowed.error();
  ByteView records = chunk.records;
  if (!chunk.compression.empty() && claimsTooMuch(chunk)) {
    return damagedChunk(fmt::format("the chunk claims {} bytes out of {}, more than {} can produce",
                                    chunk.uncompressed_size, chunk.records.size(),
                                    chunk.compression));
  }
  const auto size = static_cast<std::size_t>(chunk.uncompressed_size);
  if (isLz4(chunk)) {
    std::byte* const out = scratch.make(size);
    const Result<std::size_t> made = expandLz4(records, out, size);
    if (!made) return made.error();
    records = ByteView(out, *made);
  } else if (chunk.compression == "zstd") {
    std::byte* const out = scratch.make(size);
    const std::size_t made =
        ZSTD_decompressDCtx(contexts_->zstd, out, size, records.data(), records.size());
    if (ZSTD_isError(made) != 0U) {
      return damagedChunk(
          fmt::format("the chunk does not decompress: {}", ZSTD_getErrorName(made)));
    }
    records = ByteView(out, made);
  }
  if (records.size() != chunk.uncompressed_size) {
    return damagedChunk(fmt::format("the chunk holds {} bytes where its header says {}",
                                    records.size(), chunk.uncompressed_size));
  }
  if (chunk.uncompressed_crc != 0) {
    if (const std::uint32_t found = crc32(records); found != chunk.uncompressed_crc) {
      return damagedChunk(fmt::format("the chunk fails its checksum ({:08x}, stored {:08x})", found,
                                      chunk.uncompressed_crc));
    }
  }
  return records;
}

Result<ByteView> ChunkExpander::expandCut(const Chunk& chunk, Scratch& scratch) {
  Chunk bounded = chunk;
  if (chunk.uncompressed_size == kOpenEnded) bounded.uncompressed_size = kMaxChunkBytes;
  if (Status allowed = mayExpand(bounded); !allowed) return allowed.error();
  const std::uint64_t size = bounded.uncompressed_size;
  if (chunk.compression.empty()) {
    return chunk.records.first(
        static_cast<std::size_t>(std::min<std::uint64_t>(size, chunk.records.size())));
  }
  const std::uint64_t growth = isLz4(chunk) ? kMaxLz4Growth : kMaxZstdGrowth;
  const auto bound =
      static_cast<std::size_t>(std::min<std::uint64_t>(size, (chunk.records.size() + 1) * growth));
  if (isLz4(chunk)) {
    std::byte* const out = scratch.make(bound);
    return ByteView(out, expandCutLz4(chunk.records, out, bound));
  }
  // Grows as it fills: a few bytes of a cut chunk must not take the memory of a large one.
  std::size_t room = std::min(bound, std::max(kFirstRoom, 4 * chunk.records.size()));
  ZSTD_outBuffer out{scratch.make(room), room, 0};
  ZSTD_inBuffer in{chunk.records.data(), 0, 0};
  ZSTD_DCtx_reset(contexts_->zstd, ZSTD_reset_session_only);
  std::size_t wanted = kFrameHeadBytes;
  while (true) {
    // At most the one block that zstd asks for: an error discards the output of its call.
    in.size = in.pos + std::min(wanted, chunk.records.size() - in.pos);
    const std::size_t in_before = in.pos;
    const std::size_t out_before = out.pos;
    wanted = ZSTD_decompressStream(contexts_->zstd, &out, &in);
    if (ZSTD_isError(wanted) != 0U || wanted == 0) break;
    if (out.pos == out.size && room < bound) {
      room = std::min(bound, 2 * room);
      out.dst = scratch.grow(room, out.pos);
      out.size = room;
    } else if (out.pos == out.size || (in.pos == in_before && out.pos == out_before)) {
      break;
    }
  }
  return ByteView(static_cast<const std::byte*>(out.dst), out.pos);
}

std::optional<std::uint64_t> zstdFrameBytes(ByteView bytes) {
  const std::size_t found = ZSTD_findFrameCompressedSize(bytes.data(), bytes.size());
  if (ZSTD_isError(found) != 0U) return std::nullopt;
  return found;
}

std::optional<std::uint64_t> zstdContentBytes(ByteView bytes) {
  const unsigned long long found = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  if (found == ZSTD_CONTENTSIZE_ERROR || found == ZSTD_CONTENTSIZE_UNKNOWN) return std::nullopt;
  return found;
}

}  // namespace rocinante::mcap
