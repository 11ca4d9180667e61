#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/log/byte_cursor.h"
#include "core/log/log_index.h"
#include "core/log/log_profile.h"
#include "core/log/mcap_stream_reader.h"

namespace rocinante {

using mcap::Opcode;

namespace {

/// Loose messages are taken together up to this, so that a run is read like a chunk.
constexpr std::uint64_t kLooseRunBytes = 1U << 20U;

/// Before the records of a Chunk: times, sizes, CRC, compression's length, records' length.
constexpr std::uint64_t kChunkFixedBytes = 8 + 8 + 8 + 4 + 4 + 8;

/// Schemas, channels and the like that are larger are not looked for behind damage.
constexpr std::size_t kMostPlausibleBytes = 1U << 16U;

bool knownCompression(std::string_view name) {
  return name.empty() || name == "zstd" || name == "lz4";
}

/// Walks over one file. Every step either takes a record or says why it cannot.
class Walk {
 public:
  explicit Walk(ByteView file) : file_(file), decoder_(file) {}

  LogIndex run() {
    position_ = mcap::magic().size();
    while (position_ < file_.size() && !index_.closed) {
      if (!takeRecord()) skipDamage();
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
    index_.damage.push_back({from, to, std::move(cause), lost});
  }

  /// Takes the record at position_ and moves behind it. False when there is none to take.
  bool takeRecord() {
    const std::optional<mcap::Record> record = mcap::recordAt(file_, position_);
    if (!record) return takeCutChunk();
    if (record->opcode != Opcode::message_index) endChunk(record->opcode <= Opcode::data_end);
    switch (record->opcode) {
      case Opcode::header:
        return takeSimple(*record, index_.header);
      case Opcode::schema:
        return takeSimple(*record, schema_);
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

  /// Fields that we do not know may follow the known ones. Whole records may not: then the length
  /// is what is wrong, and believing it would swallow them.
  void moveBehind(const mcap::Record& record, std::size_t used) {
    position_ = record.end();
    const std::uint64_t known_end = record.offset + mcap::kPrefixBytes + used;
    if (known_end == position_ || !plausibleAt(known_end)) return;
    damaged(record.offset, known_end, "a record's length reaches over the records behind it",
            std::uint64_t{0});
    position_ = known_end;
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
    // Recorders of our profile write none: it is another record with a broken opcode.
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
    if (!used || !knownCompression(chunk.compression)) return takeCutChunk();
    moveBehind(record, *used);
    startChunk(chunk, record.offset, record.offset + mcap::kPrefixBytes + *used);
    return true;
  }

  void startChunk(const mcap::Chunk& chunk, std::uint64_t offset, std::uint64_t end) {
    chunks_seen_ = true;
    chunk_.emplace();
    chunk_->offset = offset;
    chunk_->end = end;
    chunk_->chunk = chunk;
    chunk_->start_time = logTimeOf(chunk.message_start_time);
    chunk_->end_time = logTimeOf(chunk.message_end_time);
    indexed_counts_.clear();
    indexed_start_ = std::numeric_limits<std::uint64_t>::max();
    indexed_end_ = 0;
  }

  bool takeMessageIndex(const mcap::Record& record) {
    mcap::MessageIndex message_index;
    if (!takeSimple(record, message_index)) return false;
    if (!chunk_) {
      damaged(record.offset, record.end(), "a message index follows no chunk",
              message_index.records.size());
      return true;
    }
    if (message_index.records.empty()) return true;
    indexed_counts_[message_index.channel_id] += message_index.records.size();
    for (const auto& [log_time, offset] : message_index.records) {
      indexed_start_ = std::min(indexed_start_, log_time);
      indexed_end_ = std::max(indexed_end_, log_time);
    }
    return true;
  }

  /// The chunk is taken by its indexes where they and its header tell the same, name known channels
  /// only and are `followed` by a sound record, so that none is missing; else it is expanded.
  void endChunk(bool followed) {
    if (!chunk_) return;
    MessageSpan span = std::move(*chunk_);
    chunk_.reset();
    bool trusted = followed && !indexed_counts_.empty() && !span.cut &&
                   indexed_start_ == span.chunk.message_start_time &&
                   indexed_end_ == span.chunk.message_end_time;
    for (const auto& [channel, count] : indexed_counts_) {
      trusted = trusted && index_.channels.contains(channel);
    }
    if (trusted) {
      for (const auto& [channel, count] : indexed_counts_) {
        index_.message_counts[channel] += count;
        span.channels.push_back(channel);
      }
      index_.spans.push_back(std::move(span));
    } else {
      expandChunk(std::move(span));
    }
  }

  void expandChunk(MessageSpan span) {
    decoder_.decode(span, scratch_);
    // One that is defined twice is told when the chunk is read.
    for (const mcap::Channel& channel : scratch_.channels) addChannel(index_, channel);
    const std::vector<SpanMessages::Place>& places = scratch_.places;
    // The reader would find the same faults again.
    if (places.empty()) {
      std::ranges::copy(scratch_.damage, std::back_inserter(index_.damage));
      return;
    }
    const LogTime start{Nanoseconds(places.front().time_ns)};
    const LogTime end{Nanoseconds(places.back().time_ns)};
    if (!span.cut && (start != span.start_time || end != span.end_time)) {
      damaged(span.offset, span.offset + mcap::kPrefixBytes + kChunkFixedBytes,
              "the header of a chunk gives other times than its messages have", std::uint64_t{0});
    }
    span.start_time = start;
    span.end_time = end;
    std::map<ChannelId, std::uint64_t> counts;
    for (const SpanMessages::Place& place : places) ++counts[place.channel];
    if (!indexed_counts_.empty() && counts != indexed_counts_) {
      damaged(span.offset, span.end, "the message indexes behind a chunk do not tell its messages",
              std::uint64_t{0});
    }
    for (const auto& [channel, count] : counts) {
      index_.message_counts[channel] += count;
      span.channels.push_back(channel);
    }
    index_.spans.push_back(std::move(span));
  }

  /// A chunk that its own lengths do not describe: cut off by the end of the file, or with one of
  /// its two lengths damaged, when the other tells where it ends.
  bool takeCutChunk() {
    if (file_.size() - position_ < mcap::kPrefixBytes + kChunkFixedBytes ||
        file_[static_cast<std::size_t>(position_)] != static_cast<std::byte>(Opcode::chunk)) {
      return false;
    }
    mcap::ByteCursor cursor(file_.subspan(static_cast<std::size_t>(position_) + 1));
    const auto length = cursor.number<std::uint64_t>();
    mcap::Chunk chunk;
    chunk.message_start_time = cursor.number<std::uint64_t>();
    chunk.message_end_time = cursor.number<std::uint64_t>();
    chunk.uncompressed_size = cursor.number<std::uint64_t>();
    chunk.uncompressed_crc = cursor.number<std::uint32_t>();
    chunk.compression = cursor.string();
    const auto records_bytes = cursor.number<std::uint64_t>();
    if (!cursor.ok() || !knownCompression(chunk.compression)) return false;
    const std::uint64_t available = cursor.remaining();
    const std::uint64_t header_bytes = kChunkFixedBytes + chunk.compression.size();
    const std::uint64_t records_start = position_ + mcap::kPrefixBytes + header_bytes;
    const std::uint64_t by_length = length >= header_bytes ? length - header_bytes : 0;
    for (const std::uint64_t size : {records_bytes, by_length}) {
      if (size == 0 || size > available || !plausibleAt(records_start + size)) continue;
      endChunk(false);
      endLooseRun();
      damaged(position_, records_start, "the two lengths of a chunk contradict each other",
              std::uint64_t{0});
      chunk.records = cursor.take(size);
      startChunk(chunk, position_, records_start + size);
      position_ = records_start + size;
      return true;
    }
    if (by_length != records_bytes) return false;
    endChunk(false);
    endLooseRun();
    chunk.records = cursor.take(available);
    startChunk(chunk, position_, file_.size());
    chunk_->cut = true;
    damaged(position_, file_.size(),
            fmt::format("the file ends inside a chunk: {} of its {} bytes are there", available,
                        records_bytes),
            std::nullopt);
    position_ = file_.size();
    return true;
  }

  bool takeAttachment(const mcap::Record& record) {
    mcap::Attachment attachment;
    if (!takeSimple(record, attachment)) return false;
    index_.attachments.push_back({std::move(attachment.name), std::move(attachment.media_type),
                                  logTimeOf(attachment.log_time), attachment.data.size()});
    index_.attachment_offsets.push_back(record.offset);
    return true;
  }

  bool takeMetadata(const mcap::Record& record) {
    mcap::Metadata metadata;
    if (!takeSimple(record, metadata)) return false;
    index_.metadata.push_back({std::move(metadata.name), std::move(metadata.metadata)});
    return true;
  }

  /// What follows is the summary, which is not needed here; the channels that have no message stand
  /// nowhere else, so it is looked through for those as far as it is sound.
  bool takeDataEnd(const mcap::Record& record) {
    mcap::DataEnd data_end;
    if (!mcap::parse(record.content, data_end)) return false;
    position_ = record.end();
    summary_begun_ = true;
    endLooseRun();
    while (const std::optional<mcap::Record> next = mcap::recordAt(file_, position_)) {
      mcap::Channel channel;
      if (next->opcode == Opcode::channel && mcap::parse(next->content, channel) &&
          !index_.channels.contains(channel.id)) {
        addChannel(index_, channel);
      }
      position_ = next->end();
      if (next->opcode != Opcode::footer) continue;
      index_.closed =
          next->content.size() == mcap::kFooterContentBytes &&
          std::ranges::equal(file_.subspan(static_cast<std::size_t>(position_)), mcap::magic());
      break;
    }
    if (!index_.closed) {
      damaged(record.end(), file_.size(), "the file ends inside its summary", std::uint64_t{0});
    }
    position_ = file_.size();
    return true;
  }

  /// True when the bytes at `offset` begin a record that can be believed: known by its opcode, with
  /// lengths that fit, and followed by another or by the end.
  bool plausibleAt(std::uint64_t offset) const {
    if (offset == file_.size()) return true;
    const std::optional<mcap::Record> record = mcap::recordAt(file_, offset);
    if (!record || !plausible(*record)) return false;
    if (record->end() == file_.size()) return true;
    const std::optional<mcap::Record> next = mcap::recordAt(file_, record->end());
    if (next) return plausible(*next);
    // Nothing whole follows: the file may have been cut there.
    return file_.size() - record->end() < mcap::kPrefixBytes || record->opcode == Opcode::footer ||
           record->opcode == Opcode::message_index || record->opcode == Opcode::chunk;
  }

  static bool plausible(const mcap::Record& record) {
    const ByteView content = record.content;
    switch (record.opcode) {
      case Opcode::chunk: {
        mcap::Chunk chunk;
        return mcap::parse(content, chunk) && knownCompression(chunk.compression) &&
               chunk.message_start_time <= chunk.message_end_time;
      }
      case Opcode::message_index: {
        mcap::ByteCursor cursor(content);
        cursor.number<std::uint16_t>();
        const ByteView records = cursor.bytes32();
        return cursor.ok() && records.size() % 16 == 0 && cursor.remaining() == 0;
      }
      case Opcode::message:
        return content.size() >= mcap::kMessageHeaderBytes;
      case Opcode::data_end:
        return content.size() == mcap::kDataEndContentBytes;
      case Opcode::footer:
        return content.size() == mcap::kFooterContentBytes;
      case Opcode::channel:
        return parses<mcap::Channel>(content);
      case Opcode::schema:
        return parses<mcap::Schema>(content);
      case Opcode::attachment:
        return parses<mcap::Attachment>(content);
      case Opcode::metadata:
        return parses<mcap::Metadata>(content);
      case Opcode::statistics:
        return parses<mcap::Statistics>(content);
      case Opcode::chunk_index:
        return parses<mcap::ChunkIndex>(content);
      case Opcode::attachment_index:
        return parses<mcap::AttachmentIndex>(content);
      case Opcode::metadata_index:
        return parses<mcap::MetadataIndex>(content);
      case Opcode::summary_offset:
        return parses<mcap::SummaryOffset>(content);
      case Opcode::invalid:
      case Opcode::header:
        return false;
    }
    return false;
  }

  template <class T>
  static bool parses(ByteView content) {
    // Looked for at every byte of damage: a hostile file must not make each look a long one.
    if (content.size() > kMostPlausibleBytes) return false;
    T ignored;
    return mcap::parse(content, ignored).has_value();
  }

  /// Goes on at the next byte that begins a believable record.
  void skipDamage() {
    const std::uint64_t from = position_;
    endChunk(false);
    endLooseRun();
    std::uint64_t next = from + 1;
    while (next < file_.size() && !resumesAt(next)) ++next;
    position_ = next;
    const bool to_end = next == file_.size();
    damaged(from, next,
            to_end ? "the file ends inside a record"
                   : "bytes that are no record; reading went on at the next one",
            std::nullopt);
  }

  bool resumesAt(std::uint64_t offset) const {
    const auto opcode = static_cast<Opcode>(file_[static_cast<std::size_t>(offset)]);
    switch (opcode) {
      case Opcode::schema:
      case Opcode::channel:
      case Opcode::message:
      case Opcode::chunk:
      case Opcode::attachment:
      case Opcode::metadata:
      case Opcode::data_end:
        return plausibleAt(offset);
      default:
        return false;
    }
  }

  ByteView file_;
  SpanDecoder decoder_;
  LogIndex index_;
  std::uint64_t position_ = 0;
  mcap::Schema schema_;
  SpanMessages scratch_;
  bool chunks_seen_ = false;
  bool summary_begun_ = false;

  std::optional<MessageSpan> loose_;  ///< the open run of loose messages
  std::optional<MessageSpan> chunk_;  ///< the chunk whose indexes are being read
  std::map<ChannelId, std::uint64_t> indexed_counts_;
  std::uint64_t indexed_start_ = 0;
  std::uint64_t indexed_end_ = 0;
};

}  // namespace

LogIndex indexByWalking(ByteView file) { return Walk(file).run(); }

}  // namespace rocinante
