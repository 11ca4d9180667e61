#include <algorithm>
#include <set>

#include "core/hash.h"
#include "core/log/byte_cursor.h"
#include "core/log/log_index.h"
#include "core/log/mcap_stream_reader.h"

namespace rocinante {

using mcap::Opcode;

bool addChannel(LogIndex& index, const mcap::Channel& channel) {
  const auto [place, added] = index.channels.try_emplace(channel.id);
  LogChannel& known = place->second;
  if (!added) {
    return known.topic == channel.topic && known.encoding == channel.message_encoding &&
           known.metadata == channel.metadata;
  }
  known = {channel.id, channel.topic, channel.message_encoding, channel.metadata};
  return true;
}

namespace {

struct Summary {
  std::vector<mcap::Channel> channels;
  std::optional<mcap::Statistics> statistics;
  std::vector<mcap::ChunkIndex> chunks;
  std::vector<mcap::AttachmentIndex> attachments;
  std::vector<mcap::MetadataIndex> metadata;
};

template <class T>
bool parseInto(ByteView content, std::vector<T>& out) {
  return mcap::parse(content, out.emplace_back()).has_value();
}

/// False at the first record that breaks the format.
bool readSummary(ByteView bytes, Summary& out) {
  for (std::uint64_t position = 0; position < bytes.size();) {
    const std::optional<mcap::Record> record = mcap::recordAt(bytes, position);
    if (!record) return false;
    bool ok = true;
    switch (record->opcode) {
      case Opcode::channel:
        ok = parseInto(record->content, out.channels);
        break;
      case Opcode::chunk_index:
        ok = parseInto(record->content, out.chunks);
        break;
      case Opcode::attachment_index:
        ok = parseInto(record->content, out.attachments);
        break;
      case Opcode::metadata_index:
        ok = parseInto(record->content, out.metadata);
        break;
      case Opcode::statistics:
        ok = mcap::parse(record->content, out.statistics.emplace()).has_value();
        break;
      default:
        break;
    }
    if (!ok) return false;
    position = record->end();
  }
  return true;
}

/// True when the optional parts that we navigate by are all there.
bool tellsAll(const Summary& summary) {
  if (!summary.statistics) return false;
  const mcap::Statistics& statistics = *summary.statistics;
  std::uint64_t messages = 0;
  std::set<std::uint16_t> known;
  for (const mcap::Channel& channel : summary.channels) known.insert(channel.id);
  for (const auto& [id, count] : statistics.channel_message_counts) {
    if (!known.contains(id)) return false;
    messages += count;
  }
  return messages == statistics.message_count &&
         summary.channels.size() == statistics.channel_count &&
         summary.chunks.size() == statistics.chunk_count &&
         summary.attachments.size() == statistics.attachment_count &&
         summary.metadata.size() == statistics.metadata_count;
}

struct FileRange {
  std::uint64_t from;
  std::uint64_t to;
};

/// The span of an indexed chunk. Empty when the chunk cannot lie there. The index is what is
/// believed where it and the chunk's own header differ (then `damage` grows), because the summary's
/// checksum covers it and nothing covers the header; the chunk's checksum has the last word.
std::optional<MessageSpan> spanOf(ByteView file, const mcap::ChunkIndex& index,
                                  std::uint64_t data_end, std::vector<DamageSpan>& damage) {
  const std::uint64_t fixed_bytes = 8 + 8 + 8 + 4 + 4 + index.compression.size() + 8;
  if (index.chunk_start_offset > data_end ||
      index.chunk_length > data_end - index.chunk_start_offset ||
      index.message_index_length > data_end - index.chunk_start_offset - index.chunk_length ||
      index.chunk_length < mcap::kPrefixBytes + fixed_bytes ||
      index.compressed_size > index.chunk_length - mcap::kPrefixBytes - fixed_bytes) {
    return std::nullopt;
  }
  MessageSpan span;
  span.offset = index.chunk_start_offset;
  span.end = index.chunk_start_offset + index.chunk_length;
  span.start_time = logTimeOf(index.message_start_time);
  span.end_time = logTimeOf(index.message_end_time);
  for (const auto& [channel, offset] : index.message_index_offsets) {
    span.channels.push_back(channel);
  }
  const ByteView content =
      file.subspan(static_cast<std::size_t>(span.offset) + mcap::kPrefixBytes,
                   static_cast<std::size_t>(index.chunk_length) - mcap::kPrefixBytes);
  const std::optional<mcap::Record> record = mcap::recordAt(file, span.offset);
  const bool agrees = record && record->opcode == Opcode::chunk && record->end() == span.end &&
                      mcap::parse(record->content, span.chunk) &&
                      span.chunk.message_start_time == index.message_start_time &&
                      span.chunk.message_end_time == index.message_end_time &&
                      span.chunk.uncompressed_size == index.uncompressed_size &&
                      span.chunk.compression == index.compression &&
                      span.chunk.records.size() == index.compressed_size;
  if (agrees) return span;
  damage.push_back({span.offset, span.offset + mcap::kPrefixBytes + fixed_bytes,
                    "the header of the chunk is not what the summary says of it; the summary is "
                    "followed",
                    std::uint64_t{0}});
  mcap::ByteCursor cursor(content);
  cursor.take(24);
  span.chunk.uncompressed_crc = cursor.number<std::uint32_t>();
  span.chunk.message_start_time = index.message_start_time;
  span.chunk.message_end_time = index.message_end_time;
  span.chunk.uncompressed_size = index.uncompressed_size;
  span.chunk.compression = index.compression == "zstd" ? "zstd"
                           : index.compression.empty() ? ""
                                                       : "unknown";
  span.chunk.records = content.subspan(static_cast<std::size_t>(fixed_bytes),
                                       static_cast<std::size_t>(index.compressed_size));
  return span;
}

/// True when nothing but what the summary does not index lies between the ranges: no message
/// outside a chunk, no forgotten chunk.
bool nothingBetween(ByteView file, std::vector<FileRange> ranges, std::uint64_t data_end) {
  ranges.push_back({data_end, data_end});
  std::ranges::sort(ranges, {}, &FileRange::from);
  std::uint64_t position = mcap::magic().size();
  for (const FileRange& range : ranges) {
    while (position < range.from) {
      const std::optional<mcap::Record> record = mcap::recordAt(file, position);
      if (!record || record->end() > range.from) return false;
      switch (record->opcode) {
        case Opcode::invalid:
        case Opcode::message:
        case Opcode::chunk:
        case Opcode::message_index:
        case Opcode::attachment:
        case Opcode::metadata:
          return false;
        default:
          break;
      }
      position = record->end();
    }
    // An overlap would say the same bytes twice.
    if (position > range.from) return false;
    position = range.to;
  }
  return true;
}

bool readIndexed(ByteView file, const Summary& summary, std::uint64_t data_end, LogIndex& out) {
  std::vector<FileRange> ranges;
  for (const mcap::ChunkIndex& index : summary.chunks) {
    std::optional<MessageSpan> span = spanOf(file, index, data_end, out.damage);
    if (!span) return false;
    ranges.push_back({span->offset, span->end + index.message_index_length});
    out.spans.push_back(std::move(*span));
  }
  for (const mcap::AttachmentIndex& index : summary.attachments) {
    const std::optional<mcap::Record> record = mcap::recordAt(file, index.offset);
    if (!record || record->opcode != Opcode::attachment || record->end() > data_end ||
        record->end() - record->offset != index.length) {
      return false;
    }
    ranges.push_back({record->offset, record->end()});
    out.attachments.push_back(
        {index.name, index.media_type, logTimeOf(index.log_time), index.data_size});
    out.attachment_offsets.push_back(index.offset);
  }
  for (const mcap::MetadataIndex& index : summary.metadata) {
    const std::optional<mcap::Record> record = mcap::recordAt(file, index.offset);
    mcap::Metadata metadata;
    if (!record || record->opcode != Opcode::metadata || record->end() > data_end ||
        record->end() - record->offset != index.length || !mcap::parse(record->content, metadata) ||
        metadata.name != index.name) {
      return false;
    }
    ranges.push_back({record->offset, record->end()});
    out.metadata.push_back({std::move(metadata.name), std::move(metadata.metadata)});
  }
  std::ranges::sort(out.spans, {}, &MessageSpan::offset);
  if (const std::optional<mcap::Record> first = mcap::recordAt(file, mcap::magic().size())) {
    if (first->opcode == Opcode::header) mcap::parse(first->content, out.header);
  }
  return nothingBetween(file, std::move(ranges), data_end);
}

}  // namespace

std::optional<LogIndex> indexFromSummary(ByteView file, std::vector<DamageSpan>& damage) {
  const std::size_t least =
      mcap::magic().size() + mcap::kPrefixBytes + mcap::kDataEndContentBytes + mcap::kFileEndBytes;
  if (file.size() < least) return std::nullopt;
  const std::size_t footer_offset = file.size() - mcap::kFileEndBytes;
  const std::optional<mcap::Record> record = mcap::recordAt(file, footer_offset);
  mcap::Footer footer;
  if (!std::ranges::equal(file.last(mcap::magic().size()), mcap::magic()) || !record ||
      record->opcode != Opcode::footer || !mcap::parse(record->content, footer)) {
    return std::nullopt;  // no whole file: the walk says where it ends
  }
  const std::uint64_t start = footer.summary_start == 0 ? footer_offset : footer.summary_start;
  const auto faulty = [&](std::string cause) {
    const std::uint64_t from = std::min<std::uint64_t>(start, footer_offset);
    damage.push_back({from, file.size(), std::move(cause), std::uint64_t{0}});
    return std::nullopt;
  };
  const std::uint64_t data_end_bytes = mcap::kPrefixBytes + mcap::kDataEndContentBytes;
  if (start > footer_offset || start < mcap::magic().size() + data_end_bytes ||
      footer.summary_offset_start > footer_offset ||
      (footer.summary_offset_start != 0 && footer.summary_offset_start < start)) {
    return faulty("the footer points outside the file");
  }
  const ByteView checked = file.subspan(
      static_cast<std::size_t>(start),
      file.size() - static_cast<std::size_t>(start) - mcap::magic().size() - sizeof(std::uint32_t));
  if (footer.summary_crc != 0 && crc32(checked) != footer.summary_crc) {
    return faulty("the summary fails its checksum");
  }
  const std::uint64_t data_end = start - data_end_bytes;
  const std::optional<mcap::Record> end_record = mcap::recordAt(file, data_end);
  if (!end_record || end_record->opcode != Opcode::data_end || end_record->end() != start) {
    return faulty("the summary does not follow the end of the data");
  }
  Summary summary;
  if (!readSummary(checked.first(footer_offset - static_cast<std::size_t>(start)), summary)) {
    return faulty("the summary is malformed");
  }
  // A valid file may leave any of it out; then the walk has to find it.
  if (!tellsAll(summary)) return std::nullopt;

  LogIndex index;
  for (const mcap::Channel& channel : summary.channels) {
    if (!addChannel(index, channel)) return faulty("the summary defines a channel twice");
  }
  for (const auto& [id, count] : summary.statistics->channel_message_counts) {
    index.message_counts.emplace(id, count);
  }
  if (!readIndexed(file, summary, data_end, index)) {
    return faulty("the summary does not agree with the file");
  }
  // Without a checksum a summary that is at odds with a chunk proves nothing against the chunk.
  if (!index.damage.empty() && footer.summary_crc == 0) {
    return faulty("the summary, which has no checksum, does not agree with the file");
  }
  index.closed = true;
  return index;
}

}  // namespace rocinante
