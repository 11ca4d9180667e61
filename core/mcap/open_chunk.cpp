#include "core/mcap/open_chunk.h"

#include <algorithm>
#include <cassert>

#include "core/base/hash.h"
#include "core/mcap/append_record.h"
#include "core/mcap/byte_cursor.h"
#include "core/mcap/chunk_head.h"

namespace rocinante::mcap {
namespace {

// A chunk that had at most this when it was begun belongs to a slow session (600 packets a second),
// where pieces are small and compress badly, and time is free. Above, a higher level gains nothing.
constexpr std::size_t kSlowBytes = std::size_t{4} << 10U;
constexpr int kSlowLevel = 6;

template <class T>
std::byte* put(std::byte* at, T value) {
  std::memcpy(at, &value, sizeof(value));
  return at + sizeof(value);
}

std::size_t headerBytes(const std::string& compression) {
  return kChunkHeadBytes + compression.size();
}

/// Writes the Chunk record up to its records; with open lengths if `open`.
void putHeader(std::byte* at, const ChunkIndex& index, std::uint32_t crc, bool open) {
  const auto known = [open](std::uint64_t value) { return open ? kOpenEnded : value; };
  at = put(at, static_cast<std::uint8_t>(Opcode::chunk));
  at = put(at, known(index.chunk_length - kPrefixBytes));
  at = put(at, index.message_start_time);
  at = put(at, known(index.message_end_time));
  at = put(at, known(index.uncompressed_size));
  at = put(at, open ? 0U : crc);
  at = put(at, static_cast<std::uint32_t>(index.compression.size()));
  std::memcpy(at, index.compression.data(), index.compression.size());
  put(at + index.compression.size(), known(index.compressed_size));
}

}  // namespace

OpenChunk::OpenChunk(std::optional<int> zstd_level, std::size_t chunk_bytes, bool message_indexes)
    : zstd_level_(zstd_level),
      chunk_bytes_(chunk_bytes),
      message_indexes_(message_indexes),
      buffer_(kHeaderRoom) {
  if (zstd_level) compressor_.emplace(*zstd_level);
}

void OpenChunk::add(Part& part, const Message& message) {
  assert(stage_ <= Stage::open);
  if (parts_.empty()) {
    index_.message_start_time = index_.message_end_time = message.log_time;
  } else {
    index_.message_start_time = std::min(index_.message_start_time, message.log_time);
    index_.message_end_time = std::max(index_.message_end_time, message.log_time);
  }
  if (part.index.records.empty()) parts_.push_back(&part);
  part.index.records.emplace_back(message.log_time, bytes());
  append(buffer_, message);
}

std::uint64_t OpenChunk::indexBytes() const {
  if (!message_indexes_) return 0;
  std::uint64_t bytes = 0;
  for (const Part* part : parts_) {
    bytes += kPrefixBytes + 2 + 4 + 16 * part->index.records.size();
  }
  return bytes;
}

std::uint64_t OpenChunk::closingBytes() const { return sizeof(FrameStream::kEnd) + indexBytes(); }

Status OpenChunk::flush(GrowingFile& file, std::uint64_t tail_bytes) {
  assert(stage_ <= Stage::open);
  if (!unflushed()) return {};
  const bool first = stage_ == Stage::in_memory;
  if (first) {
    index_.chunk_start_offset = file.size();
    index_.compression = zstd_level_ ? "zstd" : "";
    const bool slow = pending().size() <= kSlowBytes;
    if (zstd_level_) {
      stream_.begin(slow ? std::max(*zstd_level_, kSlowLevel) : *zstd_level_, chunk_bytes_);
    }
  }
  const std::size_t header = first ? headerBytes(index_.compression) : 0;
  ByteView piece = ByteView(buffer_).subspan(kHeaderRoom - header);
  std::byte* header_at = buffer_.data() + kHeaderRoom - header;
  if (compressed()) {
    out_.assign(header, std::byte{});
    if (Status made = stream_.add(pending(), FrameStream::Until::flushed, out_); !made) return made;
    piece = out_;
    header_at = out_.data();
  }
  if (first) putHeader(header_at, index_, 0, /*open=*/true);
  return appendPiece(file, piece, header, tail_bytes + closingBytes());
}

Status OpenChunk::appendPiece(GrowingFile& file, ByteView piece, std::size_t header_bytes,
                              std::uint64_t tail_bytes) {
  if (Status written = file.appendUncounted(piece, tail_bytes); !written) return written;
  stage_ = Stage::open;
  const ByteView stored = piece.subspan(header_bytes);
  index_.compressed_size += stored.size();
  kept_crc_ = crc32(pending(), kept_crc_);
  stored_crc_ = compressed() ? crc32(stored, stored_crc_) : kept_crc_;
  kept_bytes_ += pending().size();
  buffer_.resize(kHeaderRoom);
  return {};
}

Status OpenChunk::close(GrowingFile& file, std::uint64_t tail_bytes) {
  if (stage_ == Stage::in_memory) return closeInOnePiece(file, tail_bytes);
  if (stage_ == Stage::open) {
    if (Status ended = endData(file, tail_bytes); !ended) return ended;
  }
  if (stage_ == Stage::ended) {
    if (Status patched = patchHeader(file); !patched) return patched;
  }
  return stage_ == Stage::patched ? appendIndexes(file, tail_bytes) : Status{};
}

Status OpenChunk::closeInOnePiece(GrowingFile& file, std::uint64_t tail_bytes) {
  out_.assign(kHeaderRoom, std::byte{});
  const bool smaller = compressor_ && compressor_->compressInto(pending(), out_);
  Bytes& piece = smaller ? out_ : buffer_;
  kept_crc_ = crc32(pending());
  index_.compression = smaller ? "zstd" : "";
  index_.chunk_start_offset = file.size();
  index_.uncompressed_size = pending().size();
  index_.compressed_size = piece.size() - kHeaderRoom;
  const std::size_t header = headerBytes(index_.compression);
  index_.chunk_length = header + index_.compressed_size;
  const std::size_t from = kHeaderRoom - header;
  putHeader(piece.data() + from, index_, kept_crc_, /*open=*/false);
  putIndexes(piece, file.size() - from);

  // One write for the chunk and its indexes: the file gets both or neither.
  const ByteView whole = ByteView(piece).subspan(from);
  if (smaller) {
    if (Status written = file.append(whole, tail_bytes); !written) return written;
  } else {
    if (Status written = file.appendUncounted(whole, tail_bytes); !written) return written;
    const ByteView indexes = whole.subspan(static_cast<std::size_t>(index_.chunk_length));
    file.count(crc32(whole.first(header)), header);
    file.count(kept_crc_, index_.uncompressed_size);
    file.count(crc32(indexes), indexes.size());
  }
  buffer_.resize(kHeaderRoom);
  stage_ = Stage::closed;
  return file.settle(index_.chunk_start_offset);
}

Status OpenChunk::endData(GrowingFile& file, std::uint64_t tail_bytes) {
  tail_bytes += indexBytes();
  if (unflushed()) {
    ByteView piece = pending();
    if (compressed()) {
      out_.clear();
      if (Status made = stream_.add(pending(), FrameStream::Until::ended, out_); !made) return made;
      piece = out_;
    }
    if (Status written = appendPiece(file, piece, 0, tail_bytes); !written) return written;
  } else if (compressed()) {
    const ByteView end = std::as_bytes(std::span(FrameStream::kEnd));
    if (Status written = appendPiece(file, end, 0, tail_bytes); !written) return written;
  }
  stage_ = Stage::ended;
  return {};
}

Status OpenChunk::patchHeader(GrowingFile& file) {
  const std::size_t header = headerBytes(index_.compression);
  index_.chunk_length = header + index_.compressed_size;
  index_.uncompressed_size = kept_bytes_;
  out_.resize(header);
  putHeader(out_.data(), index_, kept_crc_, /*open=*/false);
  if (Status done = file.overwrite(index_.chunk_start_offset, out_); !done) return done;
  file.count(crc32(out_), header);
  file.count(stored_crc_, index_.compressed_size);
  stage_ = Stage::patched;
  return {};
}

Status OpenChunk::appendIndexes(GrowingFile& file, std::uint64_t tail_bytes) {
  stage_ = Stage::closed;
  out_.clear();
  putIndexes(out_, file.size());
  if (Status written = file.append(out_, tail_bytes); !written) {
    // No index offsets means that they are unknown.
    index_.message_index_offsets.clear();
    index_.message_index_length = 0;
    return written;
  }
  return file.settle(index_.chunk_start_offset);
}

/// `file_offset` is the offset of the first byte of `out`.
void OpenChunk::putIndexes(Bytes& out, std::uint64_t file_offset) {
  if (!message_indexes_) return;
  const std::size_t before = out.size();
  out.reserve(before + static_cast<std::size_t>(indexBytes()));
  for (const Part* part : parts_) {
    index_.message_index_offsets.emplace(part->index.channel_id, file_offset + out.size());
    append(out, part->index);
  }
  index_.message_index_length = out.size() - before;
}

std::vector<std::pair<std::uint16_t, std::uint64_t>> OpenChunk::dropUnflushed() {
  std::vector<std::pair<std::uint16_t, std::uint64_t>> dropped;
  for (Part* part : parts_) {
    auto& records = part->index.records;
    const auto first = std::ranges::lower_bound(records, kept_bytes_, {},
                                                [](const auto& each) { return each.second; });
    if (first == records.end()) continue;
    dropped.emplace_back(part->index.channel_id, records.end() - first);
    records.erase(first, records.end());
    if (records.empty()) part->declared = false;
  }
  std::erase_if(parts_, [](const Part* part) { return part->index.records.empty(); });
  index_.message_start_time = parts_.empty() ? 0 : ~std::uint64_t{0};
  index_.message_end_time = 0;
  for (const Part* part : parts_) {
    for (const auto& [log_time, offset] : part->index.records) {
      index_.message_start_time = std::min(index_.message_start_time, log_time);
      index_.message_end_time = std::max(index_.message_end_time, log_time);
    }
  }
  index_.message_index_offsets.clear();
  buffer_.resize(kHeaderRoom);
  return dropped;
}

void OpenChunk::startNext() {
  for (Part* part : parts_) {
    part->index.records.clear();
    part->declared = false;
  }
  parts_.clear();
  buffer_.resize(kHeaderRoom);
  index_ = {};
  kept_bytes_ = 0;
  kept_crc_ = stored_crc_ = 0;
  stage_ = Stage::in_memory;
}

}  // namespace rocinante::mcap
