#include "core/log/message_span.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/base/figure_text.h"
#include "core/log/chunk_indexes.h"
#include "core/mcap/byte_cursor.h"
#include "core/mcap/parse_record.h"
#include "core/mcap/record_stepper.h"

namespace rocinante {

using mcap::Opcode;

namespace {

/// Larger than any chunk that is expanded at all. A run of messages outside chunks may be longer if
/// it is a single message; it is not copied then.
constexpr std::uint64_t kMaxStoredBytes = mcap::kMaxChunkBytes + mcap::kMaxChunkBytes / 64;

constexpr auto kLastFileTime = static_cast<std::uint64_t>(kLastLogTime.time_since_epoch().count());

}  // namespace

LogTime logTimeOf(std::uint64_t file_time) {
  return LogTime(Nanoseconds(static_cast<std::int64_t>(std::min(file_time, kLastFileTime))));
}

bool MessageSpan::hasMessages() const {
  return start_time != LogTime{} || end_time != LogTime{} || !channels.empty();
}

bool MessageSpan::mayHold(ChannelId channel) const {
  return channels.empty() || std::ranges::binary_search(channels, channel);
}

mcap::Chunk SpanDecoder::chunkInFile(const MessageSpan& span,
                                     std::vector<DamageSpan>& damage) const {
  const mcap::Chunk& listed = span.chunk;
  const std::optional<mcap::Record> record = mcap::recordAt(file_, span.offset);
  mcap::Chunk found;
  if (record && record->opcode == Opcode::chunk && record->end() == span.end &&
      mcap::parse(record->content, found) &&
      found.message_start_time == listed.message_start_time &&
      found.message_end_time == listed.message_end_time &&
      found.uncompressed_size == listed.uncompressed_size &&
      found.compression == listed.compression && found.records.data() == listed.records.data() &&
      found.records.size() == listed.records.size()) {
    return found;
  }
  damage.push_back({span.offset, span.offset + kChunkHeadBytes + listed.compression.size(),
                    "the header of the chunk disagrees with the summary; the summary is used",
                    std::uint64_t{0}});
  found = listed;
  mcap::ByteCursor cursor(file_.subspan(static_cast<std::size_t>(span.offset)));
  cursor.take(mcap::kPrefixBytes + 3 * sizeof(std::uint64_t));
  found.uncompressed_crc = cursor.number<std::uint32_t>();
  return found;
}

/// The bytes, which are in the file, read from the file itself if there is one.
Result<ByteView> SpanDecoder::stored(ByteView bytes, mcap::Scratch& scratch) const {
  if (mapped_ == nullptr || bytes.size() > kMaxStoredBytes) return bytes;
  const std::span<std::byte> copy(scratch.make(bytes.size()), bytes.size());
  if (mapped_->read(static_cast<std::uint64_t>(bytes.data() - file_.data()), copy)) return copy;
  return Error{ErrorKind::unreadable,
               "the file was truncated while it was read, or cannot be read any more",
               {}};
}

Result<ByteView> SpanDecoder::expand(const MessageSpan& span, SpanMessages& out) {
  if (span.over_budget) {
    return Error{ErrorKind::damaged, mcap::ExpansionBudget::refusal(), {}};
  }
  if (span.loose) {
    return stored(file_.subspan(static_cast<std::size_t>(span.offset),
                                static_cast<std::size_t>(span.end - span.offset)),
                  out.scratch);
  }
  const bool plain = span.chunk.compression.empty();
  mcap::Chunk chunk = span.chunk;
  if (chunk.records.size() > kMaxStoredBytes) {
    if (!span.cut) {
      return Error{ErrorKind::damaged,
                   fmt::format("the chunk is {} bytes long; at most {} are expanded",
                               chunk.records.size(), kMaxStoredBytes),
                   {}};
    }
    chunk.records = chunk.records.first(static_cast<std::size_t>(kMaxStoredBytes));
  }
  Result<ByteView> records = stored(chunk.records, plain ? out.scratch : compressed_);
  if (!records) return records;
  // Safe to access in memory: stored() has just read the records behind this header.
  if (span.by_summary) chunk = chunkInFile(span, out.damage);
  chunk.records = *records;
  return span.cut ? expander_.expandCut(chunk, out.scratch) : expander_.expand(chunk, out.scratch);
}

void SpanDecoder::decode(const MessageSpan& span, SpanMessages& out) {
  out.records = {};
  out.places.clear();
  out.channels.clear();
  out.schemas.clear();
  out.damage.clear();
  Result<ByteView> records = expand(span, out);
  if (!records) {
    out.damage.push_back({span.offset, span.end, records.error().what, indexedMessages(span)});
    return;
  }
  out.records = *records;
  readRecords(span, out);
  // Nearly always sorted already: recorders write in time order.
  if (!std::is_sorted(out.places.begin(), out.places.end())) {
    std::sort(out.places.begin(), out.places.end());
  }
}

void SpanDecoder::readRecords(const MessageSpan& span, SpanMessages& out) {
  std::uint64_t malformed = 0;
  std::uint64_t too_late = 0;
  mcap::RecordStepper steps(out.records);
  while (const std::optional<mcap::Record> record = steps.next()) {
    if (record->opcode == Opcode::message) {
      mcap::Message message;
      if (!mcap::parse(record->content, message)) {
        ++malformed;
      } else if (message.log_time > kLastFileTime) {
        ++too_late;
      } else {
        out.places.push_back({static_cast<std::int64_t>(message.log_time),
                              static_cast<std::uint32_t>(record->offset), message.channel_id});
      }
    } else if (record->opcode == Opcode::channel) {
      out.channels.push_back(record->content);
    } else if (record->opcode == Opcode::schema) {
      out.schemas.push_back(record->content);
    }
  }
  if (!steps.atEnd() && !span.cut) {
    out.damage.push_back(
        {span.offset, span.end,
         fmt::format("a record reaches past the end of its chunk, {} bytes into it",
                     steps.position()),
         std::nullopt});
  }
  if (malformed > 0) {
    out.damage.push_back(
        {span.offset, span.end, countText(malformed, "malformed message"), malformed});
  }
  if (too_late > 0) {
    out.damage.push_back({span.offset, span.end,
                          fmt::format("a log time is beyond the last, 2^63 - 2 ns, in {} of its "
                                      "messages",
                                      too_late),
                          too_late});
  }
}

std::optional<std::uint64_t> SpanDecoder::indexedMessages(const MessageSpan& span) const {
  if (!whole()) return std::nullopt;
  // What broke the chunk may have broken its indexes: too small a number would hide a loss.
  std::vector<mcap::IndexEntries> indexes;
  mcap::RecordStepper steps(file_, span.end);
  std::optional<mcap::Record> record = steps.peek();
  for (; record && record->opcode == Opcode::message_index; record = steps.peek()) {
    const std::optional<mcap::IndexEntries> index = mcap::indexEntries(record->content);
    if (!index || !span.mayHold(index->channel) ||
        mcap::IndexEntries::kHeadBytes + index->entries.size() != record->content.size()) {
      return std::nullopt;
    }
    if (index->size() > 0) indexes.push_back(*index);
    steps.moveTo(record->end());
  }
  if (!record && !steps.atEnd()) return std::nullopt;
  if (span.by_summary && steps.position() != span.index_end) return std::nullopt;
  if (!indexesSpan(indexes, span.chunk)) return std::nullopt;
  std::ranges::sort(indexes, {}, &mcap::IndexEntries::channel);
  const auto of_one_channel = [](const mcap::IndexEntries& a, const mcap::IndexEntries& b) {
    return a.channel == b.channel;
  };
  if (std::adjacent_find(indexes.begin(), indexes.end(), of_one_channel) != indexes.end()) {
    return std::nullopt;
  }
  std::uint64_t count = 0;
  for (const mcap::IndexEntries& index : indexes) {
    const LogChannel* const channel = channels_ != nullptr && index.channel < channels_->size()
                                          ? (*channels_)[index.channel]
                                          : nullptr;
    if (channel == nullptr || channel->captured()) count += index.size();
  }
  return count;
}

std::optional<mcap::IndexEntries> SpanDecoder::indexOf(const MessageSpan& span,
                                                       ChannelId channel) const {
  if (!whole()) return std::nullopt;
  mcap::RecordStepper steps(file_, span.end);
  while (steps.position() < span.index_end) {
    const std::optional<mcap::Record> record = steps.next();
    if (!record || record->opcode != Opcode::message_index) break;
    const std::optional<mcap::IndexEntries> index = mcap::indexEntries(record->content);
    if (!index) break;
    if (index->channel == channel) return index;
  }
  return std::nullopt;
}

}  // namespace rocinante
