#include "core/log/log_index_walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "core/base/figure_text.h"
#include "core/base/hash.h"
#include "core/log/chunk_indexes.h"
#include "core/log/log_end.h"
#include "core/log/log_profile.h"
#include "core/mcap/byte_cursor.h"
#include "core/mcap/chunk_head.h"
#include "core/mcap/parse_record.h"
#include "core/mcap/record_stepper.h"
#include "core/mcap/torn_chunk.h"

namespace rocinante {

using mcap::Opcode;

namespace {

/// Loose messages are grouped up to this size, so that a run is read like a chunk.
constexpr std::uint64_t kLooseRunBytes = 1U << 20U;

/// While a file is written, a longer record that its end cuts is no record.
constexpr std::uint64_t kMostAwaitedBytes = mcap::kMaxChunkBytes;

/// Of the file, between two calls of releasePages().
constexpr std::uint64_t kWalkBeforeRelease = std::uint64_t{64} << 20U;

}  // namespace

void IndexWalk::run(bool being_written) {
  const std::size_t damages = index_.damage.size();
  while (at_.position < file_.size() && !index_.closed) {
    if (being_written && cutAt(at_.position)) break;
    if (!takeRecord()) skipDamage(probe_.resumeBehind(at_.position));
    releasePages();
  }
  if (being_written) at_.indexes.clear();  // the others may be still to come
  endChunk(false);
  endLooseRun();
  if (!index_.closed && !index_.ended) {
    damaged(file_.size(), file_.size(), "the file ends without a summary: it was never closed",
            std::nullopt);
  }
  // What is not written yet is not lost.
  while (being_written && !index_.closed && index_.damage.size() > damages &&
         index_.damage.back().to == file_.size()) {
    index_.damage.pop_back();
  }
}

void IndexWalk::damaged(std::uint64_t from, std::uint64_t to, std::string cause,
                        std::optional<std::uint64_t> lost) {
  addDamage(index_, {from, to, std::move(cause), lost});
}

void IndexWalk::takeTrailing(std::uint64_t end) {
  if (end < file_.size()) damaged(end, file_.size(), trailingText(file_, end), std::nullopt);
}

bool IndexWalk::cutAt(std::uint64_t position) const {
  if (mcap::recordAt(file_, position)) return false;
  if (const auto head = chunkHeadAt(file_, position); head && head->open()) return false;
  mcap::ByteCursor cursor(file_.subspan(static_cast<std::size_t>(position)));
  if (cursor.number<std::uint8_t>() == 0) return false;
  const auto length = cursor.number<std::uint64_t>();
  return !cursor.ok() || length <= kMostAwaitedBytes || length == mcap::kOpenEnded;
}

void IndexWalk::releasePages() {
  if (mapped_ == nullptr || at_.position - released_ < kWalkBeforeRelease) return;
  mapped_->releasePages();
  released_ = at_.position;
}

bool IndexWalk::takeRecord() {
  const std::optional<mcap::Record> record = mcap::recordAt(file_, at_.position);
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
  at_.position = record->end();  // a private or later opcode
  return true;
}

template <class T>
bool IndexWalk::takeSimple(const mcap::Record& record, T& out) {
  const std::optional<std::size_t> used = mcap::parse(record.content, out);
  if (!used) return false;
  moveBehind(record, *used);
  return true;
}

void IndexWalk::moveBehind(const mcap::Record& record, std::size_t used) {
  at_.position = record.end();
  const std::uint64_t known_end = record.offset + mcap::kPrefixBytes + used;
  if (known_end == at_.position || !probe_.plausibleAt(known_end)) return;
  damaged(record.offset, known_end, "a record's length reaches over the records after it",
          std::uint64_t{0});
  at_.position = known_end;
}

bool IndexWalk::takeSchema(const mcap::Record& record) {
  mcap::Schema schema;
  if (!takeSimple(record, schema)) return false;
  addSchema(index_, std::move(schema));
  return true;
}

bool IndexWalk::takeChannel(const mcap::Record& record) {
  mcap::Channel channel;
  if (!takeSimple(record, channel)) return false;
  define(channel, record.offset, record.end());
  return true;
}

void IndexWalk::define(const mcap::Channel& channel, std::uint64_t from, std::uint64_t to) {
  if (addChannel(index_, channel)) return;
  damaged(from, to, fmt::format("channel {} is defined again as another", channel.id),
          std::nullopt);
}

bool IndexWalk::takeMessage(const mcap::Record& record) {
  mcap::Message message;
  if (!mcap::parse(record.content, message)) return false;
  // Our recorders write none: it is another record with a broken opcode.
  if (index_.header.profile == profile::kName) return false;
  at_.position = record.end();
  if (!at_.loose && at_.chunks_seen) {
    damaged(record.offset, record.end(),
            "messages lie outside the chunks, where no checksum covers them", std::uint64_t{0});
  }
  if (at_.loose && record.end() - at_.loose->offset > kLooseRunBytes) endLooseRun();
  const LogTime time = logTimeOf(message.log_time);
  if (!at_.loose) {
    at_.loose.emplace();
    at_.loose->loose = true;
    at_.loose->offset = record.offset;
    at_.loose->start_time = at_.loose->end_time = time;
  }
  at_.loose->end = record.end();
  at_.loose->start_time = std::min(at_.loose->start_time, time);
  at_.loose->end_time = std::max(at_.loose->end_time, time);
  ++index_.message_counts[message.channel_id];
  return true;
}

void IndexWalk::endLooseRun() {
  if (!at_.loose) return;
  index_.spans.push_back(std::move(*at_.loose));
  at_.loose.reset();
}

bool IndexWalk::takeChunk(const mcap::Record& record) {
  endLooseRun();
  mcap::Chunk chunk;
  const std::optional<std::size_t> used = mcap::parse(record.content, chunk);
  if (!used || !knownCompression(chunk.compression) || chunkHeadAt(file_, record.offset)->open()) {
    return takeTornChunk();
  }
  moveBehind(record, *used);
  startChunk(chunk, record.offset, record.offset + mcap::kPrefixBytes + *used);
  return true;
}

MessageSpan& IndexWalk::startChunk(const mcap::Chunk& chunk, std::uint64_t offset,
                                   std::uint64_t end) {
  at_.chunks_seen = true;
  at_.chunk.emplace();
  at_.chunk->offset = offset;
  at_.chunk->end = at_.chunk->index_end = end;
  at_.chunk->chunk = chunk;
  at_.chunk->chunk.compression = compressionName(chunk.compression);
  at_.chunk->start_time = logTimeOf(chunk.message_start_time);
  at_.chunk->end_time = logTimeOf(chunk.message_end_time);
  at_.indexes.clear();
  return *at_.chunk;
}

bool IndexWalk::takeMessageIndex(const mcap::Record& record) {
  const std::optional<mcap::IndexEntries> index = mcap::indexEntries(record.content);
  if (!index) return false;
  moveBehind(record, mcap::IndexEntries::kHeadBytes + index->entries.size());
  if (!at_.chunk) {
    damaged(record.offset, record.end(), "a message index does not follow a chunk", index->size());
    return true;
  }
  at_.chunk->index_end = at_.position;
  if (index->size() > 0) at_.indexes.push_back(*index);
  return true;
}

void IndexWalk::endChunk(bool followed) {
  if (!at_.chunk) return;
  MessageSpan span = std::move(*at_.chunk);
  at_.chunk.reset();
  if (!span.cut) span.over_budget = !at_.budget.take(span.chunk);
  bool trusted = followed && !span.cut && indexesSpan(at_.indexes, span.chunk);
  for (const mcap::IndexEntries& index : at_.indexes) {
    trusted = trusted && index_.channels.contains(index.channel);
  }
  if (!trusted) return expandChunk(std::move(span));
  std::uint64_t messages = 0;
  for (const mcap::IndexEntries& index : at_.indexes) {
    index_.message_counts[index.channel] += index.size();
    messages += index.size();
  }
  span.indexed_messages = messages;
  addSpan(std::move(span), at_.indexes, &mcap::IndexEntries::channel);
}

template <class Range, class Channel>
void IndexWalk::addSpan(MessageSpan span, const Range& range, Channel channel) {
  for (const auto& each : range) span.channels.push_back(std::invoke(channel, each));
  std::ranges::sort(span.channels);
  span.channels.erase(std::unique(span.channels.begin(), span.channels.end()), span.channels.end());
  index_.spans.push_back(std::move(span));
}

void IndexWalk::expandChunk(MessageSpan span) {
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
    span.over_budget = !at_.budget.take(span.chunk);
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
  for (const mcap::IndexEntries& index : at_.indexes) indexed[index.channel] += index.size();
  if (!indexed.empty() && counts != indexed) {
    damaged(span.offset, span.end, "the message indexes after a chunk do not match its messages",
            std::uint64_t{0});
    span.index_end = span.end;
  }
  for (const auto& [channel, count] : counts) index_.message_counts[channel] += count;
  addSpan(std::move(span), counts, [](const auto& each) { return each.first; });
}

bool IndexWalk::takeTornChunk() {
  std::optional<TornChunk> torn = tornChunkAt(file_, at_.position, probe_);
  if (!torn) return false;
  endChunk(false);
  endLooseRun();
  damaged(at_.position, torn->end, std::move(torn->cause), torn->messages_lost);
  startChunk(torn->chunk, at_.position, torn->end).cut = torn->cut;
  at_.position = torn->end;
  return true;
}

bool IndexWalk::takeAttachment(const mcap::Record& record) {
  mcap::Attachment attachment;
  return takeSimple(record, attachment) && addAttachment(record, index_);
}

bool IndexWalk::takeMetadata(const mcap::Record& record) {
  mcap::Metadata metadata;
  return takeSimple(record, metadata) && addMetadata(record, index_);
}

bool IndexWalk::takeDataEnd(const mcap::Record& record) {
  mcap::DataEnd data_end;
  if (!mcap::parse(record.content, data_end)) return false;
  at_.position = record.end();
  index_.ended = true;
  endLooseRun();
  std::optional<mcap::Statistics> statistics;
  mcap::RecordStepper steps(file_, at_.position);
  while (const std::optional<mcap::Record> next = steps.next()) {
    mcap::Channel channel;
    if (next->opcode == Opcode::channel && mcap::parse(next->content, channel)) {
      addChannel(index_, channel);
    }
    mcap::Schema schema;
    if (next->opcode == Opcode::schema && mcap::parse(next->content, schema)) {
      addSchema(index_, std::move(schema));
    }
    if (next->opcode == Opcode::statistics) mcap::parse(next->content, statistics.emplace());
    if (next->opcode != Opcode::footer) continue;
    if (statistics && isSound(*next, record.end())) compareCounts(*statistics, record.offset);
    index_.closed =
        next->content.size() == mcap::kFooterContentBytes && magicAt(file_, steps.position());
    break;
  }
  if (index_.closed) takeTrailing(steps.position() + mcap::magic().size());
  if (!index_.closed) {
    damaged(record.end(), file_.size(), "the file ends inside its summary", std::uint64_t{0});
  }
  at_.position = file_.size();
  return true;
}

bool IndexWalk::isSound(const mcap::Record& footer_record, std::uint64_t start) const {
  mcap::Footer footer;
  if (!mcap::parse(footer_record.content, footer) || footer.summary_crc == 0) return false;
  const std::uint64_t end = footer_record.end() - sizeof(footer.summary_crc);
  return crc32(file_.subspan(static_cast<std::size_t>(start),
                             static_cast<std::size_t>(end - start))) == footer.summary_crc;
}

void IndexWalk::compareCounts(const mcap::Statistics& statistics, std::uint64_t data_end) {
  std::uint64_t found = 0;
  for (const auto& [channel, count] : index_.message_counts) found += count;
  const bool is_known = std::ranges::any_of(
      index_.damage, [](const DamageSpan& each) { return each.messages_lost != std::uint64_t{0}; });
  if (is_known || found >= statistics.message_count) return;
  damaged(mcap::magic().size(), data_end,
          fmt::format("the statistics count {}, but {} are there: a piece of the file is missing",
                      countText(statistics.message_count, "message"), found),
          statistics.message_count - found);
}

void IndexWalk::skipDamage(std::uint64_t next) {
  const std::uint64_t from = at_.position;
  endChunk(false);
  endLooseRun();
  at_.position = next;
  const bool to_end = next == file_.size();
  damaged(from, next,
          to_end ? "the file ends inside a record"
                 : "bytes that are not a record; reading resumed at the next one",
          std::nullopt);
}

LogIndex indexByWalking(ByteView file, const MappedFile* mapped) {
  LogIndex index;
  WalkPlace begin;
  begin.budget.grow(file.size());
  IndexWalk(file, mapped, std::move(begin), index).run(false);
  return index;
}

}  // namespace rocinante
