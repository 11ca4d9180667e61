#include "core/mcap/writer.h"

#include <cassert>

#include "core/mcap/append_record.h"
#include "core/mcap/byte_cursor.h"

namespace rocinante::mcap {

Writer::Writer(std::unique_ptr<ByteSink> sink, const WriterOptions& options)
    : file_(std::move(sink)),
      options_(options),
      chunk_(options.zstd_level, options.chunk_bytes, options.message_indexes),
      summary_(options) {}

Result<Writer> Writer::start(std::unique_ptr<ByteSink> sink, const WriterOptions& options,
                             const Header& header) {
  Writer writer(std::move(sink), options);
  Bytes opening(magic().begin(), magic().end());
  append(opening, header);
  if (Status written = writer.file_.append(opening, writer.tailBytes()); !written) {
    return written.error();
  }
  return writer;
}

void Writer::addSchema(Schema schema) {
  assert(schema.id != 0);
  SchemaState& state = schemas_.emplace_back();
  state.id = schema.id;
  append(state.record, schema);
  summary_.addSchema(state.record);
}

void Writer::addChannel(Channel channel) {
  const std::size_t id = channel.id;
  if (channel_by_id_.size() <= id) channel_by_id_.resize(id + 1);
  assert(channel_by_id_[id] == nullptr);
  auto state = std::make_unique<ChannelState>();
  state->schema_id = channel.schema_id;
  state->part.index.channel_id = channel.id;
  append(state->record, channel);
  summary_.addChannel(channel.id, state->record);
  channel_by_id_[id] = std::move(state);
}

void Writer::declare(ChannelState& channel, Bytes& out) {
  for (SchemaState& schema : schemas_) {
    if (schema.id == channel.schema_id && !schema.declared) {
      appendBytes(out, schema.record);
      schema.declared = true;
    }
  }
  appendBytes(out, channel.record);
  channel.part.declared = true;
}

void Writer::undeclareSchemas() {
  for (SchemaState& schema : schemas_) schema.declared = false;
}

/// The bytes that must still fit behind the records of the open chunk, so that the file can be
/// closed properly.
std::uint64_t Writer::tailBytes() const {
  std::vector<std::uint16_t> channels;
  channels.reserve(chunk_.parts().size());
  for (const OpenChunk::Part* part : chunk_.parts()) channels.push_back(part->index.channel_id);
  const std::uint64_t room = refused_ ? 0 : options_.closing_room_bytes;
  return kPrefixBytes + kDataEndContentBytes + summary_.bytes(channels) + room;
}

Status Writer::write(const Message& message) {
  assert(message.channel_id < channel_by_id_.size() && channel_by_id_[message.channel_id]);
  ChannelState& channel = *channel_by_id_[message.channel_id];
  if (!options_.chunked) return writeLoose(channel, message);
  if (refused_ && chunk_.begun()) {
    // The disk refused when it was to be closed; it may accept now.
    if (Status closed = closeChunk(); !closed) {
      ++lost_[message.channel_id];
      return closed;
    }
  }
  if (!channel.part.declared) declare(channel, chunk_.records());
  chunk_.add(channel.part, message);
  if (chunk_.bytes() >= options_.chunk_bytes) return closeChunk();
  return {};
}

Status Writer::writeLoose(ChannelState& channel, const Message& message) {
  scratch_.clear();
  if (!channel.part.declared) declare(channel, scratch_);
  append(scratch_, message);
  if (Status written = file_.append(scratch_, tailBytes()); !written) {
    ++lost_[message.channel_id];
    // Removed with the message: must be declared again before the next one.
    if (channel.messages == 0) channel.part.declared = false;
    undeclareSchemas();
    refuse();
    return written;
  }
  ++channel.messages;
  summary_.addMessages(message.channel_id, 1);
  summary_.addTimes(message.log_time, message.log_time, 1);
  return {};
}

void Writer::refuse() {
  for (const auto& [channel, count] : chunk_.dropUnflushed()) lost_[channel] += count;
  if (chunk_.empty()) {
    chunk_.startNext();
    if (options_.chunked) undeclareSchemas();
  }
  releaseRoom();
}

void Writer::releaseRoom() {
  refused_ = true;
  summary_.leaveOutUnused();
}

Status Writer::flush() {
  if (!chunk_.unflushed()) return {};
  if (!file_.overwritable()) return closeChunk();
  Status flushed = chunk_.flush(file_, tailBytes());
  if (!flushed) {
    refuse();
    (void)closeChunk();
  }
  return flushed;
}

Status Writer::closeChunk() {
  if (chunk_.empty()) return {};
  Status closed = chunk_.close(file_, tailBytes());
  if (!closed && !chunk_.closed()) {
    refuse();
    if (!chunk_.empty()) (void)chunk_.close(file_, tailBytes());
  }
  if (!closed) releaseRoom();
  if (chunk_.closed()) keepChunk();
  return closed;
}

void Writer::keepChunk() {
  std::uint64_t messages = 0;
  for (const OpenChunk::Part* part : chunk_.parts()) {
    summary_.addMessages(part->index.channel_id, part->index.records.size());
    messages += part->index.records.size();
  }
  const ChunkIndex& index = chunk_.index();
  summary_.addTimes(index.message_start_time, index.message_end_time, messages);
  summary_.addChunk(index);
  chunk_.startNext();
  undeclareSchemas();
}

Status Writer::writeAttachment(const Attachment& attachment) {
  if (Status closed = closeChunk(); !closed) return closed;
  Bytes record;  // not scratch_: it may be large, and is not needed again
  append(record, attachment);
  const AttachmentIndex index{file_.size(),           record.size(),          attachment.log_time,
                              attachment.create_time, attachment.data.size(), attachment.name,
                              attachment.media_type};
  const std::uint64_t tail = tailBytes() + Summary::bytesFor(index);
  if (Status written = file_.append(record, tail); !written) {
    releaseRoom();
    return written;
  }
  summary_.addAttachment(index);
  return file_.settle(index.offset);
}

Status Writer::writeMetadata(const Metadata& metadata) {
  if (chunk_.begun()) {
    if (Status closed = closeChunk(); !closed) return closed;
  }
  scratch_.clear();
  append(scratch_, metadata);
  const MetadataIndex index{file_.size(), scratch_.size(), metadata.name};
  const std::uint64_t tail = tailBytes() + Summary::bytesFor(index);
  if (Status written = file_.append(scratch_, tail); !written) {
    releaseRoom();
    return written;
  }
  summary_.addMetadata(index);
  return {};
}

Status Writer::finish() {
  // Every step is tried even when one before it failed: a whole summary of what did fit is worth
  // more than none. The first failure is returned.
  Status outcome = closeChunk();
  // Nothing can follow a chunk that is still open.
  if (!chunk_.begun()) {
    Bytes end;
    append(end, DataEnd{file_.crc()});
    appendBytes(end, summary_.build(file_.size() + end.size()));
    if (Status written = file_.append(end, 0); outcome && !written) outcome = written;
  }
  if (Status closed = file_.close(); outcome && !closed) outcome = closed;
  return outcome;
}

}  // namespace rocinante::mcap
