#include "core/log/log_index_walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "core/base/figure_text.h"
#include "core/base/hash.h"
#include "core/log/chunk_indexes.h"
#include "core/log/log_end.h"
#include "core/log/log_profile.h"
#include "core/mcap/chunk_head.h"
#include "core/mcap/parse_record.h"
#include "core/mcap/record_stepper.h"
#include "core/mcap/torn_chunk.h"

namespace rocinante {

using mcap::Opcode;

namespace {

/// Loose messages are grouped up to this size, so that a run is read like a chunk.
constexpr std::uint64_t kLooseRunBytes = 1U << 20U;

/// Of the file, between two calls of releasePages().
constexpr std::uint64_t kWalkBeforeRelease = std::uint64_t{64} << 20U;

/// Walks over one file. Every step either takes a record or reports why it cannot.
class Walk {
 public:
  explicit Walk(ByteView file) : file_(file), decoder_(file), probe_(file), budget_(file.size()) {}
  /// Continues where `other` is, in the same file or in what it has grown to.
  Walk(const Walk& other, ByteView file) : Walk(file) {
    budget_ = other.budget_;
    budget_.grow(file.size() - other.file_.size());
    index_ = other.index_;
    position_ = other.position_;
    chunks_seen_ = other.chunks_seen_;
    loose_ = other.loose_;
    chunk_ = other.chunk_;
    indexes_ = other.indexes_;
  }

  /// Takes the records that are complete, up to the first of which that is not known: of a chunk
  /// that is still open, or that nothing follows yet, or of damage.
  void runSettled() {
    while (position_ < file_.size() && settledAt(position_) && takeRecord()) {
    }
  }
  std::size_t settledSpans() const { return index_.spans.size(); }
  std::uint64_t position() const { return position_; }

  LogIndex run(const MappedFile* mapped = nullptr) {
    std::uint64_t released = position_;
    while (position_ < file_.size() && !index_.closed) {
      if (!takeRecord()) skipDamage();
      if (mapped == nullptr || position_ - released < kWalkBeforeRelease) continue;
      mapped->releasePages();
      released = position_;
    }
    endChunk(false);
    endLooseRun();
    if (!index_.closed && !summary_begun_) {
      damaged(file_.size(), file_.size(), "the file ends without a summary: it was never closed",
              std::nullopt);
    }
    return std::move(index_);
  }

 private:
  void damaged(std::uint64_t from, std::uint64_t to, std::string cause,
               std::optional<std::uint64_t> lost) {
    addDamage(index_, {from, to, std::move(cause), lost});
  }

  /// Reports the bytes behind the end of the closed file.
  void takeTrailing(std::uint64_t end) {
    if (end < file_.size()) damaged(end, file_.size(), trailingText(file_, end), std::nullopt);
  }

  /// Whether the record there is complete, and stays as it is. The end of the log is left to run().
  bool settledAt(std::uint64_t position) const {
    const std::optional<mcap::Record> record = mcap::recordAt(file_, position);
    if (!record || record->opcode == Opcode::data_end) return false;
    if (record->opcode != Opcode::chunk) return true;
    const std::optional<ChunkHead> head = chunkHeadAt(file_, position);
    return head && !head->open() && mcap::recordAt(file_, record->end());
  }

  /// Takes the record at position_ and moves behind it. False when there is none.
  bool takeRecord() {
    const std::optional<mcap::Record> record = mcap::recordAt(file_, position_);
    if (!record) return takeTornChunk();
    if (record->opcode != Opcode::message_index) endChunk(record->opcode <= Opcode::data_end);
    switch (record->opcode) {
      case Opcode::header:
        return takeSimple(*record, index_.header);
      case Opcode::schema:
        return takeSchema(*record);
      case Opcode::channel:
        return takeChannel(*record);
      case Opcode::message:
        return takeMessage(*record);
      case Opcode::chunk:
        return takeChunk(*record);
      case Opcode::message_index:
        return takeMessageIndex(*record);
      case Opcode::attachment:
        return takeAttachment(*record);
      case Opcode::metadata:
        return takeMetadata(*record);
      case Opcode::data_end:
        return takeDataEnd(*record);
      case Opcode::invalid:
      case Opcode::footer:
      case Opcode::chunk_index:
      case Opcode::attachment_index:
      case Opcode::statistics:
      case Opcode::metadata_index:
      case Opcode::summary_offset:
        return false;  // not in the data section
    }
    position_ = record->end();  // a private or later opcode
    return true;
  }

  template <class T>
  bool takeSimple(const mcap::Record& record, T& out) {
    const std::optional<std::size_t> used = mcap::parse(record.content, out);
    if (!used) return false;
    moveBehind(record, *used);
    return true;
  }

  /// Unknown fields may follow the known ones. Whole records may not: then the length is wrong, and
  /// trusting it would skip them.
  void moveBehind(const mcap::Record& record, std::size_t used) {
    position_ = record.end();
    const std::uint64_t known_end = record.offset + mcap::kPrefixBytes + used;
    if (known_end == position_ || !probe_.plausibleAt(known_end)) return;
    damaged(record.offset, known_end, "a record's length reaches over the records after it",
            std::uint64_t{0});
    position_ = known_end;
  }

  bool takeSchema(const mcap::Record& record) {
    mcap::Schema schema;
    if (!takeSimple(record, schema)) return false;
    addSchema(index_, std::move(schema));
    return true;
  }

  bool takeChannel(const mcap::Record& record) {
    mcap::Channel channel;
    if (!takeSimple(record, channel)) return false;
    define(channel, record.offset, record.end());
    return true;
  }

  void define(const mcap::Channel& channel, std::uint64_t from, std::uint64_t to) {
    if (addChannel(index_, channel)) return;
    damaged(from, to, fmt::format("channel {} is defined again as another", channel.id),
            std::nullopt);
  }

  bool takeMessage(const mcap::Record& record) {
    mcap::Message message;
    if (!mcap::parse(record.content, message)) return false;
    // Our recorders write none: it is another record with a broken opcode.
    if (index_.header.profile == profile::kName) return false;
    position_ = record.end();
    if (!loose_ && chunks_seen_) {
      damaged(record.offset, record.end(),
              "messages lie outside the chunks, where no checksum covers them", std::uint64_t{0});
    }
    if (loose_ && record.end() - loose_->offset > kLooseRunBytes) endLooseRun();
    const LogTime time = logTimeOf(message.log_time);
    if (!loose_) {
      loose_.emplace();
      loose_->loose = true;
      loose_->offset = record.offset;
      loose_->start_time = loose_->end_time = time;
    }
    loose_->end = record.end();
    loose_->start_time = std::min(loose_->start_time, time);
    loose_->end_time = std::max(loose_->end_time, time);
    ++index_.message_counts[message.channel_id];
    return true;
  }

  void endLooseRun() {
    if (!loose_) return;
    index_.spans.push_back(std::move(*loose_));
    loose_.reset();
  }

  bool takeChunk(const mcap::Record& record) {
    endLooseRun();
    mcap::Chunk chunk;
    const std::optional<std::size_t> used = mcap::parse(record.content, chunk);
    if (!used || !knownCompression(chunk.compression) ||
        chunkHeadAt(file_, record.offset)->open()) {
      return takeTornChunk();
    }
    moveBehind(record, *used);
    startChunk(chunk, record.offset, record.offset + mcap::kPrefixBytes + *used);
    return true;
  }

  MessageSpan& startChunk(const mcap::Chunk& chunk, std::uint64_t offset, std::uint64_t end) {
    chunks_seen_ = true;
    chunk_.emplace();
    chunk_->offset = offset;
    chunk_->end = chunk_->index_end = end;
    chunk_->chunk = chunk;
    chunk_->chunk.compression = compressionName(chunk.compression);
    chunk_->start_time = logTimeOf(chunk.message_start_time);
    chunk_->end_time = logTimeOf(chunk.message_end_time);
    indexes_.clear();
    return *chunk_;
  }

  bool takeMessageIndex(const mcap::Record& record) {
    const std::optional<mcap::IndexEntries> index = mcap::indexEntries(record.content);
    if (!index) return false;
    moveBehind(record, mcap::IndexEntries::kHeadBytes + index->entries.size());
    if (!chunk_) {
      damaged(record.offset, record.end(), "a message index does not follow a chunk",
              index->size());
      return true;
    }
    chunk_->index_end = position_;
    if (index->size() > 0) indexes_.push_back(*index);
    return true;
  }

  /// Uses the chunk's indexes without expanding it if they match its header, name known channels
  /// only, and a sound record follows (`followed`), so that none is missing; otherwise expands it.
  void endChunk(bool followed) {
    if (!chunk_) return;
    MessageSpan span = std::move(*chunk_);
    chunk_.reset();
    if (!span.cut) span.over_budget = !budget_.take(span.chunk);
    bool trusted = followed && !span.cut && indexesSpan(indexes_, span.chunk);
    for (const mcap::IndexEntries& index : indexes_) {
      trusted = trusted && index_.channels.contains(index.channel);
    }
    if (!trusted) return expandChunk(std::move(span));
    std::uint64_t messages = 0;
    for (const mcap::IndexEntries& index : indexes_) {
      index_.message_counts[index.channel] += index.size();
      messages += index.size();
    }
    span.indexed_messages = messages;
    addSpan(std::move(span), indexes_, &mcap::IndexEntries::channel);
  }

  template <class Range, class Channel>
  void addSpan(MessageSpan span, const Range& range, Channel channel) {
    for (const auto& each : range) span.channels.push_back(std::invoke(channel, each));
    std::ranges::sort(span.channels);
    span.channels.erase(std::unique(span.channels.begin(), span.channels.end()),
                        span.channels.end());
    index_.spans.push_back(std::move(span));
  }

  void expandChunk(MessageSpan span) {
    decoder_.decode(span, scratch_);
    // A channel defined twice is reported when the chunk is read.
    for (const ByteView content : scratch_.channels) {
      mcap::Channel channel;
      if (mcap::parse(content, channel)) addChannel(index_, channel);
    }
    for (const ByteView content : scratch_.schemas) {
      mcap::Schema schema;
      if (mcap::parse(content, schema)) addSchema(index_, std::move(schema));
    }
    const std::vector<SpanMessages::Place>& places = scratch_.places;
    // The reader would report the same faults again.
    if (places.empty()) {
      std::ranges::copy(scratch_.damage, std::back_inserter(index_.damage));
      return;
    }
    const LogTime start{Nanoseconds(places.front().time_ns)};
    const LogTime end{Nanoseconds(places.back().time_ns)};
    // Its contents are known now, and bounded for each chunk.
    if (span.cut) {
      span.chunk.uncompressed_size = scratch_.records.size();
      span.over_budget = !budget_.take(span.chunk);
    }
    if (!span.cut && (start != span.start_time || end != span.end_time)) {
      damaged(span.offset, span.offset + kChunkHeadBytes,
              "the times in the header of a chunk are not those of its messages", std::uint64_t{0});
    }
    span.start_time = start;
    span.end_time = end;
    std::map<ChannelId, std::uint64_t> counts;
    for (const SpanMessages::Place& place : places) ++counts[place.channel];
    std::map<ChannelId, std::uint64_t> indexed;
    for (const mcap::IndexEntries& index : indexes_) indexed[index.channel] += index.size();
    if (!indexed.empty() && counts != indexed) {
      damaged(span.offset, span.end, "the message indexes after a chunk do not match its messages",
              std::uint64_t{0});
      span.index_end = span.end;
    }
    for (const auto& [channel, count] : counts) index_.message_counts[channel] += count;
    addSpan(std::move(span), counts, [](const auto& each) { return each.first; });
  }

  bool takeTornChunk() {
    std::optional<TornChunk> torn = tornChunkAt(file_, position_, probe_);
    if (!torn) return false;
    endChunk(false);
    endLooseRun();
    damaged(position_, torn->end, std::move(torn->cause), torn->messages_lost);
    startChunk(torn->chunk, position_, torn->end).cut = torn->cut;
    position_ = torn->end;
    return true;
  }

  bool takeAttachment(const mcap::Record& record) {
    mcap::Attachment attachment;
    return takeSimple(record, attachment) && addAttachment(record, index_);
  }

  bool takeMetadata(const mcap::Record& record) {
    mcap::Metadata metadata;
    return takeSimple(record, metadata) && addMetadata(record, index_);
  }

  /// The rest is the summary, which is not needed here; but channels without messages are only
  /// there, so it is searched for them as far as it is sound.
  bool takeDataEnd(const mcap::Record& record) {
    mcap::DataEnd data_end;
    if (!mcap::parse(record.content, data_end)) return false;
    position_ = record.end();
    summary_begun_ = true;
    endLooseRun();
    std::optional<mcap::Statistics> told;
    mcap::RecordStepper steps(file_, position_);
    while (const std::optional<mcap::Record> next = steps.next()) {
      mcap::Channel channel;
      if (next->opcode == Opcode::channel && mcap::parse(next->content, channel)) {
        addChannel(index_, channel);
      }
      mcap::Schema schema;
      if (next->opcode == Opcode::schema && mcap::parse(next->content, schema)) {
        addSchema(index_, std::move(schema));
      }
      if (next->opcode == Opcode::statistics) mcap::parse(next->content, told.emplace());
      if (next->opcode != Opcode::footer) continue;
      if (told && isSound(*next, record.end())) compareCounts(*told, record.offset);
      index_.closed =
          next->content.size() == mcap::kFooterContentBytes && magicAt(file_, steps.position());
      break;
    }
    if (index_.closed) takeTrailing(steps.position() + mcap::magic().size());
    if (!index_.closed) {
      damaged(record.end(), file_.size(), "the file ends inside its summary", std::uint64_t{0});
    }
    position_ = file_.size();
    return true;
  }

  /// The summary's checksum holds from `start`, wherever its footer says that it begins.
  bool isSound(const mcap::Record& footer_record, std::uint64_t start) const {
    mcap::Footer footer;
    if (!mcap::parse(footer_record.content, footer) || footer.summary_crc == 0) return false;
    const std::uint64_t end = footer_record.end() - sizeof(footer.summary_crc);
    return crc32(file_.subspan(static_cast<std::size_t>(start),
                               static_cast<std::size_t>(end - start))) == footer.summary_crc;
  }

  /// Where a piece of the file is missing from one record's end to another's, nothing looks broken.
  void compareCounts(const mcap::Statistics& told, std::uint64_t data_end) {
    std::uint64_t found = 0;
    for (const auto& [channel, count] : index_.message_counts) found += count;
    const bool is_known = std::ranges::any_of(index_.damage, [](const DamageSpan& each) {
      return each.messages_lost != std::uint64_t{0};
    });
    if (is_known || found >= told.message_count) return;
    damaged(mcap::magic().size(), data_end,
            fmt::format("the statistics count {}, but {} are there: a piece of the file is missing",
                        countText(told.message_count, "message"), found),
            told.message_count - found);
  }

  /// Resumes at the next byte that begins a credible record.
  void skipDamage() {
    const std::uint64_t from = position_;
    endChunk(false);
    endLooseRun();
    const std::uint64_t next = position_ = probe_.resumeBehind(from);
    const bool to_end = next == file_.size();
    damaged(from, next,
            to_end ? "the file ends inside a record"
                   : "bytes that are not a record; reading resumed at the next one",
            std::nullopt);
  }

  ByteView file_;
  SpanDecoder decoder_;
  RecordProbe probe_;
  mcap::ExpansionBudget budget_;
  LogIndex index_;
  std::uint64_t position_ = mcap::magic().size();
  SpanMessages scratch_;
  bool chunks_seen_ = false;
  bool summary_begun_ = false;

  std::optional<MessageSpan> loose_;  ///< the open run of loose messages
  std::optional<MessageSpan> chunk_;  ///< the chunk whose indexes are being read
  std::vector<mcap::IndexEntries> indexes_;
};

}  // namespace

LogIndex indexByWalking(ByteView file, const MappedFile* mapped) { return Walk(file).run(mapped); }

struct GrowingIndex::Impl {
  std::optional<Walk> settled;
};

GrowingIndex::GrowingIndex() : impl_(std::make_unique<Impl>()) {}
GrowingIndex::~GrowingIndex() = default;
GrowingIndex::GrowingIndex(GrowingIndex&&) noexcept = default;
GrowingIndex& GrowingIndex::operator=(GrowingIndex&&) noexcept = default;

LogIndex GrowingIndex::update(ByteView file) {
  if (impl_->settled) {
    const Walk before = *std::move(impl_->settled);
    impl_->settled.emplace(before, file);
  } else {
    impl_->settled.emplace(file);
  }
  impl_->settled->runSettled();
  return Walk(*impl_->settled, file).run();
}

std::size_t GrowingIndex::settledSpans() const {
  return impl_->settled ? impl_->settled->settledSpans() : 0;
}

std::uint64_t GrowingIndex::settledBytes() const {
  return impl_->settled ? impl_->settled->position() : 0;
}

}  // namespace rocinante
