#include "core/mcap/summary.h"

#include <algorithm>
#include <limits>

#include "core/base/hash.h"
#include "core/mcap/append_record.h"
#include "core/mcap/byte_cursor.h"

namespace rocinante::mcap {
namespace {

constexpr std::uint64_t kCountBytes = 2 + 8;  // in a map from a channel to a number
constexpr std::uint64_t kStatisticsBytes = kPrefixBytes + 8 + 2 + 4 + 4 + 4 + 4 + 8 + 8 + 4;
constexpr std::uint64_t kChunkIndexBytes = kPrefixBytes + 4 * 8 + 4 + 8 + 4 + 4 + 8 + 8;
constexpr std::uint64_t kAttachmentIndexBytes = kPrefixBytes + 5 * 8 + 4 + 4;
constexpr std::uint64_t kMetadataIndexBytes = kPrefixBytes + 2 * 8 + 4;
constexpr std::uint64_t kSummaryOffsetBytes = kPrefixBytes + 1 + 8 + 8;
constexpr std::uint64_t kGroups = 6;

}  // namespace

void Summary::addSchema(ByteView record) {
  appendBytes(schemas_, record);
  ++statistics_.schema_count;
}

void Summary::addChannel(std::uint16_t id, ByteView record) {
  channel_order_.push_back(id);
  channels_.emplace(id, ChannelEntry{Bytes(record.begin(), record.end()), 0});
  channel_bytes_ += record.size();
}

void Summary::addMessages(std::uint16_t channel_id, std::uint64_t count) {
  channels_.at(channel_id).messages += count;
}

void Summary::addTimes(std::uint64_t start, std::uint64_t end, std::uint64_t count) {
  if (count == 0) return;
  if (statistics_.message_count == 0) {
    statistics_.message_start_time = start;
    statistics_.message_end_time = end;
  }
  statistics_.message_count += count;
  statistics_.message_start_time = std::min(statistics_.message_start_time, start);
  statistics_.message_end_time = std::max(statistics_.message_end_time, end);
}

void Summary::addChunk(const ChunkIndex& index) {
  ++statistics_.chunk_count;
  if (options_.chunk_indexes) append(chunk_indexes_, index);
}

void Summary::addAttachment(const AttachmentIndex& index) {
  ++statistics_.attachment_count;
  if (options_.attachment_indexes) append(attachment_indexes_, index);
}

void Summary::addMetadata(const MetadataIndex& index) {
  ++statistics_.metadata_count;
  if (options_.metadata_indexes) append(metadata_indexes_, index);
}

std::uint64_t Summary::bytes(std::span<const std::uint16_t> chunk_channels) const {
  std::uint64_t channel_bytes = channel_bytes_;
  if (leaves_out_unused_) {
    channel_bytes = 0;
    std::vector<bool> in_chunk(std::numeric_limits<std::uint16_t>::max() + std::size_t{1});
    for (const std::uint16_t id : chunk_channels) in_chunk[id] = true;
    for (const auto& [id, channel] : channels_) {
      if (channel.messages > 0 || in_chunk[id]) channel_bytes += channel.record.size();
    }
  }
  return schemas_.size() + channel_bytes + kStatisticsBytes + kCountBytes * channels_.size() +
         chunk_indexes_.size() + kChunkIndexBytes + kCountBytes * chunk_channels.size() +
         attachment_indexes_.size() + metadata_indexes_.size() + kGroups * kSummaryOffsetBytes +
         kFileEndBytes;
}

std::uint64_t Summary::bytesFor(const AttachmentIndex& index) {
  return kAttachmentIndexBytes + index.name.size() + index.media_type.size();
}

std::uint64_t Summary::bytesFor(const MetadataIndex& index) {
  return kMetadataIndexBytes + index.name.size();
}

void Summary::appendStatistics(Bytes& out) const {
  Statistics statistics = statistics_;
  for (const auto& [id, channel] : channels_) {
    if (!leftOut(channel)) ++statistics.channel_count;
    if (channel.messages > 0) statistics.channel_message_counts.emplace(id, channel.messages);
  }
  append(out, statistics);
}

Bytes Summary::build(std::uint64_t summary_start) const {
  Bytes out;
  std::vector<SummaryOffset> groups;
  std::size_t group_start = 0;
  const auto endGroup = [&](Opcode opcode) {
    if (out.size() > group_start) {
      groups.push_back({opcode, summary_start + group_start, out.size() - group_start});
    }
    group_start = out.size();
  };

  if (options_.repeat_schemas) appendBytes(out, schemas_);
  endGroup(Opcode::schema);
  if (options_.repeat_channels) {
    for (const std::uint16_t id : channel_order_) {
      const ChannelEntry& channel = channels_.at(id);
      if (!leftOut(channel)) appendBytes(out, channel.record);
    }
  }
  endGroup(Opcode::channel);
  if (options_.statistics) appendStatistics(out);
  endGroup(Opcode::statistics);
  appendBytes(out, chunk_indexes_);
  endGroup(Opcode::chunk_index);
  appendBytes(out, attachment_indexes_);
  endGroup(Opcode::attachment_index);
  appendBytes(out, metadata_indexes_);
  endGroup(Opcode::metadata_index);

  Footer footer;
  if (!out.empty()) footer.summary_start = summary_start;
  if (options_.summary_offsets && !groups.empty()) {
    footer.summary_offset_start = summary_start + out.size();
    for (const SummaryOffset& group : groups) append(out, group);
  }
  append(out, footer);
  // The footer's last field covers everything before it, from the summary's start.
  footer.summary_crc = crc32(ByteView(out).first(out.size() - sizeof(footer.summary_crc)));
  out.resize(out.size() - kPrefixBytes - kFooterContentBytes);
  append(out, footer);
  appendBytes(out, magic());
  return out;
}

}  // namespace rocinante::mcap
