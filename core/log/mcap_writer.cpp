#include "core/log/mcap_writer.h"

#include <algorithm>
#include <cassert>

#include "core/hash.h"
#include "core/log/byte_cursor.h"

namespace rocinante::mcap {

Writer::Writer(std::unique_ptr<ByteSink> sink, const WriterOptions& options)
    : sink_(std::move(sink)), options_(options) {
  if (options.zstd_level) compressor_.emplace(*options.zstd_level);
}

Result<Writer> Writer::start(std::unique_ptr<ByteSink> sink, const WriterOptions& options,
                             const Header& header) {
  Writer writer(std::move(sink), options);
  Bytes opening(magic().begin(), magic().end());
  append(opening, header);
  if (Status written = writer.put(opening); !written) return written.error();
  return writer;
}

void Writer::addSchema(Schema schema) {
  assert(schema.id != 0);
  schemas_.push_back({std::move(schema), false});
}

void Writer::addChannel(Channel channel) {
  const std::size_t id = channel.id;
  if (channel_by_id_.size() <= id) channel_by_id_.resize(id + 1, nullptr);
  assert(channel_by_id_[id] == nullptr);
  auto state = std::make_unique<ChannelState>();
  state->index.channel_id = channel.id;
  state->channel = std::move(channel);
  channel_by_id_[id] = state.get();
  channels_.push_back(std::move(state));
}

Status Writer::put(ByteView bytes) {
  if (Status written = sink_->append(bytes); !written) {
    // Best effort: on a device nothing can be taken back, and the first error is the telling one.
    (void)sink_->truncate(position_);
    return written;
  }
  data_crc_ = crc32(bytes, data_crc_);
  position_ += bytes.size();
  return {};
}

void Writer::declare(ChannelState& channel, Bytes& out) {
  for (SchemaState& schema : schemas_) {
    if (schema.schema.id == channel.channel.schema_id && !schema.declared) {
      append(out, schema.schema);
      schema.declared = true;
    }
  }
  append(out, channel.channel);
  channel.declared = true;
}

void Writer::countMessage(std::uint64_t log_time) {
  if (statistics_.message_count == 0) {
    statistics_.message_start_time = statistics_.message_end_time = log_time;
  }
  ++statistics_.message_count;
  statistics_.message_start_time = std::min(statistics_.message_start_time, log_time);
  statistics_.message_end_time = std::max(statistics_.message_end_time, log_time);
}

Status Writer::write(const Message& message) {
  assert(message.channel_id < channel_by_id_.size() && channel_by_id_[message.channel_id]);
  ChannelState& channel = *channel_by_id_[message.channel_id];
  if (!options_.chunked) {
    scratch_.clear();
    if (!channel.declared) declare(channel, scratch_);
    append(scratch_, message);
    if (Status written = put(scratch_); !written) {
      ++lost_[message.channel_id];
      // Taken back with the message: to be said again before the next one.
      if (channel.messages == 0) channel.declared = false;
      for (SchemaState& schema : schemas_) schema.declared = false;
      return written;
    }
    ++channel.messages;
    countMessage(message.log_time);
    return {};
  }
  if (!channel.declared) declare(channel, chunk_);
  if (chunk_channels_.empty()) {
    chunk_start_time_ = chunk_end_time_ = message.log_time;
  } else {
    chunk_start_time_ = std::min(chunk_start_time_, message.log_time);
    chunk_end_time_ = std::max(chunk_end_time_, message.log_time);
  }
  if (channel.index.records.empty()) chunk_channels_.push_back(&channel);
  channel.index.records.emplace_back(message.log_time, chunk_.size());
  append(chunk_, message);
  if (chunk_.size() >= options_.chunk_bytes) return closeChunk();
  return {};
}

Status Writer::closeChunk() {
  if (chunk_.empty()) return {};
  ChunkCompressor::Compressed stored{"", chunk_};
  if (compressor_) stored = compressor_->compress(chunk_);

  Chunk chunk;
  chunk.message_start_time = chunk_start_time_;
  chunk.message_end_time = chunk_end_time_;
  chunk.uncompressed_size = chunk_.size();
  chunk.uncompressed_crc = crc32(chunk_);
  chunk.compression = stored.compression;
  chunk.records = stored.records;

  ChunkIndex index;
  index.message_start_time = chunk_start_time_;
  index.message_end_time = chunk_end_time_;
  index.chunk_start_offset = position_;
  index.compression = stored.compression;
  index.compressed_size = stored.records.size();
  index.uncompressed_size = chunk_.size();

  // One write for the chunk and its indexes: both are there, or neither.
  scratch_.clear();
  append(scratch_, chunk);
  index.chunk_length = scratch_.size();
  if (options_.message_indexes) {
    for (const ChannelState* channel : chunk_channels_) {
      index.message_index_offsets.emplace(channel->channel.id, position_ + scratch_.size());
      append(scratch_, channel->index);
    }
  }
  index.message_index_length = scratch_.size() - index.chunk_length;
  if (Status written = put(scratch_); !written) {
    for (const ChannelState* channel : chunk_channels_) {
      lost_[channel->channel.id] += channel->index.records.size();
    }
    startChunk();
    return written;
  }
  for (ChannelState* channel : chunk_channels_) {
    channel->messages += channel->index.records.size();
    for (const auto& [log_time, offset] : channel->index.records) countMessage(log_time);
  }
  ++statistics_.chunk_count;
  chunk_indexes_.push_back(std::move(index));
  startChunk();
  return {};
}

void Writer::startChunk() {
  chunk_.clear();
  for (ChannelState* channel : chunk_channels_) {
    channel->index.records.clear();
    channel->declared = false;
  }
  for (SchemaState& schema : schemas_) schema.declared = false;
  chunk_channels_.clear();
}

Status Writer::writeAttachment(const Attachment& attachment) {
  if (Status closed = closeChunk(); !closed) return closed;
  Bytes record;
  append(record, attachment);
  AttachmentIndex index{position_,
                        record.size(),
                        attachment.log_time,
                        attachment.create_time,
                        attachment.data.size(),
                        attachment.name,
                        attachment.media_type};
  if (Status written = put(record); !written) return written;
  attachment_indexes_.push_back(std::move(index));
  ++statistics_.attachment_count;
  return {};
}

Status Writer::writeMetadata(const Metadata& metadata) {
  Bytes record;
  append(record, metadata);
  MetadataIndex index{position_, record.size(), metadata.name};
  if (Status written = put(record); !written) return written;
  metadata_indexes_.push_back(std::move(index));
  ++statistics_.metadata_count;
  return {};
}

Bytes Writer::summary(std::uint64_t summary_start) const {
  Bytes out;
  std::vector<SummaryOffset> groups;
  std::size_t group_start = 0;
  const auto endGroup = [&](Opcode opcode) {
    if (out.size() > group_start) {
      groups.push_back({opcode, summary_start + group_start, out.size() - group_start});
    }
    group_start = out.size();
  };

  if (options_.repeat_schemas) {
    for (const SchemaState& schema : schemas_) append(out, schema.schema);
  }
  endGroup(Opcode::schema);
  if (options_.repeat_channels) {
    for (const auto& channel : channels_) append(out, channel->channel);
  }
  endGroup(Opcode::channel);
  if (options_.statistics) {
    Statistics statistics = statistics_;
    statistics.schema_count = static_cast<std::uint16_t>(schemas_.size());
    statistics.channel_count = static_cast<std::uint32_t>(channels_.size());
    for (const auto& channel : channels_) {
      if (channel->messages == 0) continue;
      statistics.channel_message_counts.emplace(channel->channel.id, channel->messages);
    }
    append(out, statistics);
  }
  endGroup(Opcode::statistics);
  if (options_.chunk_indexes) {
    for (const ChunkIndex& index : chunk_indexes_) append(out, index);
  }
  endGroup(Opcode::chunk_index);
  if (options_.attachment_indexes) {
    for (const AttachmentIndex& index : attachment_indexes_) append(out, index);
  }
  endGroup(Opcode::attachment_index);
  if (options_.metadata_indexes) {
    for (const MetadataIndex& index : metadata_indexes_) append(out, index);
  }
  endGroup(Opcode::metadata_index);

  Footer footer;
  if (!out.empty()) footer.summary_start = summary_start;
  if (options_.summary_offsets && !groups.empty()) {
    footer.summary_offset_start = summary_start + out.size();
    for (const SummaryOffset& group : groups) append(out, group);
  }
  append(out, footer);
  // The footer's last field covers all that stands before it, from the summary's start.
  footer.summary_crc = crc32(ByteView(out).first(out.size() - sizeof(footer.summary_crc)));
  out.erase(out.end() - static_cast<std::ptrdiff_t>(kPrefixBytes + kFooterContentBytes), out.end());
  append(out, footer);
  appendBytes(out, magic());
  return out;
}

Status Writer::finish() {
  // Each step is tried even when one before it failed: a whole summary of what did fit is worth
  // more than none. The first failure is the answer.
  Status outcome = closeChunk();
  Bytes end;
  append(end, DataEnd{data_crc_});
  appendBytes(end, summary(position_ + end.size()));
  if (Status written = put(end); outcome && !written) outcome = written;
  if (Status closed = sink_->close(); outcome && !closed) outcome = closed;
  return outcome;
}

}  // namespace rocinante::mcap
