#include "core/log/followed_records.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "core/base/hash.h"
#include "core/log/log_profile.h"
#include "core/mcap/parse_record.h"

namespace rocinante {

using mcap::Opcode;

namespace {

constexpr std::uint64_t kMaxCompressionName = 32;
constexpr std::uint64_t kMaxHeadBytes = kChunkHeadBytes + kMaxCompressionName;
constexpr std::uint64_t kPieceBytes = 1U << 16U;
/// A larger metadata record or header is not ours, and is skipped.
constexpr std::uint64_t kMaxMetadataBytes = 1U << 24U;

bool overflows(std::uint64_t position, std::uint64_t length) {
  return length > std::numeric_limits<std::int64_t>::max() - position;
}

std::uint64_t lengthIn(ByteView prefix) {
  std::uint64_t length = 0;
  std::memcpy(&length, prefix.data() + 1, sizeof(length));
  return length;
}

}  // namespace

Error FollowedRecords::damagedAt(std::uint64_t offset, std::string what) const {
  return {ErrorKind::damaged, std::move(what), fmt::format("{}, byte {}", file_->name(), offset)};
}

void FollowedRecords::damaged(std::string cause, std::optional<std::uint64_t> lost) {
  const bool open = stage_ == Stage::open_chunk || stage_ == Stage::open_plain_chunk;
  const std::uint64_t to = open ? position_ : chunk_to_;
  // The same fault of many records in one chunk is reported once.
  if (!damage_.empty() && damage_.back().from == chunk_from_ && damage_.back().cause == cause) {
    DamageSpan& last = damage_.back();
    if (last.messages_lost && lost) *last.messages_lost += *lost;
    return;
  }
  damage_.push_back({chunk_from_, to, std::move(cause), lost});
}

Status FollowedRecords::read(std::uint64_t offset, std::uint64_t count) {
  stored_.resize(static_cast<std::size_t>(count));
  return file_->read(offset, stored_);
}

/// Empty when its name is too long to be one, or the file ends inside it: see `stored_`.
Result<std::optional<ChunkHead>> FollowedRecords::readHead(std::uint64_t offset) {
  if (Status got = read(offset, std::min(kMaxHeadBytes, size_ - offset)); !got) return got.error();
  return chunkHeadAt(stored_, 0);
}

Status FollowedRecords::look() {
  const Result<std::uint64_t> now = file_->size();
  if (!now) return now.error();
  if (*now < used_) {
    return Error{ErrorKind::unreadable, "the file was truncated while it was followed",
                 file_->name()};
  }
  size_ = *now;
  return {};
}

Result<bool> FollowedRecords::readMagic() {
  const ByteView magic = mcap::magic();
  const auto there = static_cast<std::size_t>(std::min<std::uint64_t>(size_, magic.size()));
  if (Status got = read(0, there); !got) return got.error();
  if (!std::ranges::equal(stored_, magic.first(there))) {
    return damagedAt(0, "the file does not start with the MCAP magic");
  }
  if (there < magic.size()) return false;
  used_ = position_ = there;
  return true;
}

Result<std::optional<FollowedRecord>> FollowedRecords::step() {
  found_.reset();
  while (!found_) {
    const Result<bool> stepped = stepOn();
    if (!stepped) return stepped.error();
    if (!*stepped) break;
  }
  return found_;
}

Result<bool> FollowedRecords::stepOn() {
  switch (stage_) {
    case Stage::between:
      return position_ == 0 ? readMagic() : stepBetween();
    case Stage::whole_chunk:
      return stepInWholeChunk();
    case Stage::open_chunk:
      return stepInOpenChunk();
    case Stage::open_plain_chunk:
      return stepInPlainChunk();
    case Stage::ended:
      break;
  }
  return false;
}

/// `end`: how far the file had to be read for the record.
void FollowedRecords::find(const mcap::Record& record, std::uint64_t end) {
  found_ = {record, spans_ == 0 ? 0 : spans_ - 1, end <= quiet_until_};
}

Result<bool> FollowedRecords::stepBetween() {
  if (!have(mcap::kPrefixBytes)) return false;
  if (completed_unchecked_) {
    completed_unchecked_ = false;
    if (Status checked = checkCompleted(); !checked) return checked.error();
  }
  if (Status got = read(position_, mcap::kPrefixBytes); !got) return got.error();
  const auto opcode = static_cast<Opcode>(stored_[0]);
  const std::uint64_t length = lengthIn(stored_);
  if (opcode == Opcode::chunk) return beginChunk();
  if (opcode == Opcode::data_end || opcode == Opcode::footer) {
    stage_ = Stage::ended;
    return true;
  }
  if (opcode == Opcode::invalid || overflows(position_, length)) {
    return damagedAt(position_, "there is no valid record here");
  }
  return takeBetween(opcode, length);
}

/// Takes or skips the record at `position_`, which is outside of chunks.
Result<bool> FollowedRecords::takeBetween(Opcode opcode, std::uint64_t length) {
  const std::uint64_t whole = mcap::kPrefixBytes + length;
  const bool is_essential = opcode == Opcode::message || opcode == Opcode::channel;
  const bool is_wanted = is_essential || opcode == Opcode::header || opcode == Opcode::metadata;
  if (!is_wanted || length > (is_essential ? mcap::kMaxChunkBytes : kMaxMetadataBytes)) {
    if (is_essential) {
      chunk_from_ = position_;
      chunk_to_ = position_ + whole;
      damaged("the record is too large to be read");
    }
    // The next record follows it, perhaps far beyond the current end of the file.
    position_ += whole;
    return true;
  }
  if (!have(whole)) return false;
  if (Status got = read(position_, whole); !got) return got.error();
  chunk_from_ = position_;
  chunk_to_ = used_ = position_ += whole;
  const mcap::Record record{opcode, 0, ByteView(stored_).subspan(mcap::kPrefixBytes)};
  if (opcode == Opcode::header) {
    mcap::Header header;
    if (!mcap::parse(record.content, header)) {
      damaged("the header's lengths do not fit the header", 0);
    }
    ours_ = header.profile == profile::kName;
    return true;
  }
  if (opcode == Opcode::message && ours_) {
    // Our recorders write none: it is another record with a broken opcode.
    damaged("a message is outside the chunks, where no checksum covers it");
    return true;
  }
  if (opcode == Opcode::message) ++spans_;
  find(record, position_);
  return true;
}

Result<bool> FollowedRecords::beginChunk() {
  const Result<std::optional<ChunkHead>> read_head = readHead(position_);
  if (!read_head) return read_head.error();
  if (!*read_head) {
    if (stored_.size() < kMaxHeadBytes) return false;
    return damagedAt(position_, "the header of a chunk is invalid");
  }
  const ChunkHead& head = **read_head;
  chunk_from_ = position_;
  if (head.open()) return beginOpenChunk(head);
  if (overflows(position_, head.length) || head.length < head.records_start - mcap::kPrefixBytes) {
    return damagedAt(position_, "the length of a chunk is invalid");
  }
  chunk_to_ = position_ + mcap::kPrefixBytes + head.length;
  const bool is_quiet = chunk_to_ <= quiet_until_ && ours_;
  if (is_quiet || head.length > mcap::kMaxChunkBytes + kMaxHeadBytes) {
    // Our chunks each define what they use, so skipping one loses nothing else.
    if (!is_quiet) damaged("the chunk is too large to be read");
    ++spans_;
    position_ = chunk_to_;
    return true;
  }
  if (chunk_to_ > size_) return false;
  ++spans_;
  return expandWholeChunk();
}

Result<bool> FollowedRecords::beginOpenChunk(const ChunkHead& head) {
  const std::string_view compression = head.chunk.compression;
  if (!compression.empty() && compression != "zstd") {
    return damagedAt(position_, "an open chunk has a compression other than zstd or none");
  }
  ++spans_;
  used_ = position_ += head.records_start;
  stage_ = compression.empty() ? Stage::open_plain_chunk : Stage::open_chunk;
  stream_.begin();
  charged_ = 0;
  plain_start_ = position_;
  plain_crc_ = 0;
  return true;
}

Result<bool> FollowedRecords::expandWholeChunk() {
  if (Status got = read(chunk_from_, chunk_to_ - chunk_from_); !got) return got.error();
  used_ = position_ = chunk_to_;
  mcap::Chunk chunk;
  if (!mcap::parse(ByteView(stored_).subspan(mcap::kPrefixBytes), chunk)) {
    damaged("the chunk's lengths do not fit the chunk");
    return true;
  }
  budget_.grow(chunk_to_ - chunk_from_);
  if (!budget_.take(chunk)) {
    damaged(mcap::ExpansionBudget::refusal());
    return true;
  }
  const Result<ByteView> expanded = expander_.expand(chunk, scratch_);
  if (!expanded) {
    damaged(expanded.error().what);
    return true;
  }
  in_chunk_ = mcap::RecordStepper(*expanded);
  stage_ = Stage::whole_chunk;
  return true;
}

Result<bool> FollowedRecords::stepInWholeChunk() {
  if (const std::optional<mcap::Record> record = in_chunk_.next()) {
    find(*record, chunk_to_);
    return true;
  }
  if (!in_chunk_.atEnd()) damaged("a record reaches past the end of its chunk");
  stage_ = Stage::between;
  return true;
}

Result<bool> FollowedRecords::stepInOpenChunk() {
  const std::uint64_t expanded = stream_.expandedBytes();
  if (!budget_.take(expanded - charged_)) {
    return damagedAt(chunk_from_, mcap::ExpansionBudget::refusal());
  }
  charged_ = expanded;
  const Result<std::optional<mcap::Record>> record = stream_.next();
  if (!record) return damagedAt(chunk_from_, record.error().what);
  if (*record) {
    find(**record, position_);
    return true;
  }
  if (stream_.ended()) {
    endOpenChunk(stream_.expandedBytes(), stream_.crc());
    return true;
  }
  // Messages that end before `quiet_until_` must be told apart from later ones.
  const std::uint64_t until = position_ < quiet_until_ ? std::min(size_, quiet_until_) : size_;
  if (position_ >= until) return false;
  if (Status got = read(position_, std::min(until - position_, kPieceBytes)); !got) {
    return got.error();
  }
  const Result<std::size_t> fed = stream_.feed(stored_);
  budget_.grow(stored_.size());
  if (!fed) return damagedAt(chunk_from_, fed.error().what);
  used_ = position_ += *fed;
  return true;
}

/// The same for an uncompressed chunk: taken record by record, so that a half-written one is never
/// used.
Result<bool> FollowedRecords::stepInPlainChunk() {
  if (!have(mcap::kPrefixBytes)) return false;
  if (Status got = read(position_, mcap::kPrefixBytes); !got) return got.error();
  const auto opcode = static_cast<Opcode>(stored_[0]);
  if (opcode != Opcode::schema && opcode != Opcode::channel && opcode != Opcode::message) {
    endOpenChunk(position_ - plain_start_, plain_crc_);
    return true;
  }
  const std::uint64_t length = lengthIn(stored_);
  if (length > mcap::kMaxChunkBytes) {
    return damagedAt(position_, fmt::format("a chunk claims a record of {} bytes", length));
  }
  const std::uint64_t whole = mcap::kPrefixBytes + length;
  if (!have(whole)) return false;
  if (Status got = read(position_, whole); !got) return got.error();
  plain_crc_ = crc32(stored_, plain_crc_);
  const mcap::Record record{opcode, position_ - plain_start_,
                            ByteView(stored_).subspan(mcap::kPrefixBytes)};
  used_ = position_ += whole;
  find(record, position_);
  return true;
}

void FollowedRecords::endOpenChunk(std::uint64_t bytes, std::uint32_t crc) {
  expanded_bytes_ = bytes;
  expanded_crc_ = crc;
  completed_unchecked_ = true;
  stage_ = Stage::between;
}

/// Checks the header of a chunk that was read while open; it is written before anything behind the
/// chunk.
Status FollowedRecords::checkCompleted() {
  const Result<std::optional<ChunkHead>> head = readHead(chunk_from_);
  if (!head) return head.error();
  chunk_to_ = position_;
  if (!*head || (*head)->open()) {
    damaged("the header of a chunk was never closed", 0);
    return {};
  }
  const mcap::Chunk& chunk = (*head)->chunk;
  if (chunk_from_ + (*head)->records_start + (*head)->records_bytes != position_ ||
      chunk.uncompressed_size != expanded_bytes_ ||
      (chunk.uncompressed_crc != 0 && chunk.uncompressed_crc != expanded_crc_)) {
    damaged("the header of a chunk does not match what was read from it", 0);
  }
  return {};
}

}  // namespace rocinante
