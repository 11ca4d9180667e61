#include "core/log/log_index_summary.h"

#include <algorithm>
#include <set>

#include "core/base/hash.h"
#include "core/mcap/byte_cursor.h"
#include "core/mcap/parse_record.h"
#include "core/mcap/record_probe.h"
#include "core/mcap/record_stepper.h"

namespace rocinante {

using mcap::Opcode;

namespace {

/// The parts of a ChunkIndex that the reader uses, without a map for each: a long log has very
/// many.
struct ChunkPlace {
  MessageSpan span;
  std::uint64_t compressed_size = 0;
};

struct Summary {
  std::vector<mcap::Schema> schemas;
  std::vector<mcap::Channel> channels;
  std::optional<mcap::Statistics> statistics;
  std::vector<ChunkPlace> chunks;
  std::vector<mcap::AttachmentIndex> attachments;
  std::vector<mcap::MetadataIndex> metadata;
};

template <class T>
bool parseInto(ByteView content, std::vector<T>& out) {
  return mcap::parse(content, out.emplace_back()).has_value();
}

bool parseInto(ByteView content, std::vector<ChunkPlace>& out) {
  ChunkPlace& place = out.emplace_back();
  MessageSpan& span = place.span;
  mcap::ByteCursor cursor(content);
  span.chunk.message_start_time = cursor.number<std::uint64_t>();
  span.chunk.message_end_time = cursor.number<std::uint64_t>();
  span.offset = cursor.number<std::uint64_t>();
  const auto chunk_length = cursor.number<std::uint64_t>();
  const ByteView index_offsets = cursor.bytes32();
  const auto index_length = cursor.number<std::uint64_t>();
  span.chunk.compression = compressionName(cursor.string());
  place.compressed_size = cursor.number<std::uint64_t>();
  span.chunk.uncompressed_size = cursor.number<std::uint64_t>();
  constexpr std::size_t kPairBytes = sizeof(ChannelId) + sizeof(std::uint64_t);
  if (!cursor.ok() || index_offsets.size() % kPairBytes != 0) return false;
  span.end = span.offset + chunk_length;
  span.index_end = span.end + index_length;
  // The sum overflowed.
  if (span.end < span.offset || span.index_end < span.end) return false;
  span.start_time = logTimeOf(span.chunk.message_start_time);
  span.end_time = logTimeOf(span.chunk.message_end_time);
  span.channels.reserve(index_offsets.size() / kPairBytes);
  for (mcap::ByteCursor each(index_offsets); each.remaining() > 0;) {
    span.channels.push_back(each.number<ChannelId>());
    each.number<std::uint64_t>();
  }
  std::ranges::sort(span.channels);
  span.by_summary = true;
  return true;
}

/// False at the first record that breaks the format.
bool readSummary(ByteView bytes, Summary& out) {
  for (mcap::RecordStepper steps(bytes); !steps.atEnd();) {
    const std::optional<mcap::Record> record = steps.next();
    if (!record) return false;
    bool ok = true;
    switch (record->opcode) {
      case Opcode::schema:
        ok = parseInto(record->content, out.schemas);
        break;
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
  }
  return true;
}

/// True when the parts needed for navigation are all there. Metadata and attachments may lack their
/// indexes: they are found between the chunks.
bool isComplete(const Summary& summary) {
  if (!summary.statistics) return false;
  const mcap::Statistics& statistics = *summary.statistics;
  // These are outside chunks, and no index lists them.
  if (summary.chunks.empty() && statistics.message_count > 0) return false;
  std::uint64_t messages = 0;
  std::vector<bool> known(std::size_t{1} << 16U, false);
  for (const mcap::Channel& channel : summary.channels) known[channel.id] = true;
  for (const auto& [id, count] : statistics.channel_message_counts) {
    if (!known[id]) return false;
    messages += count;
  }
  return messages == statistics.message_count &&
         summary.channels.size() == statistics.channel_count &&
         summary.chunks.size() == statistics.chunk_count;
}

struct FileRange {
  std::uint64_t from;
  std::uint64_t to;
};

/// Completes the span of an indexed chunk. False when the chunk cannot be there.
bool place(ByteView file, ChunkPlace& indexed, std::uint64_t data_end) {
  MessageSpan& span = indexed.span;
  const std::uint64_t head_bytes = kChunkHeadBytes + span.chunk.compression.size();
  if (span.index_end > data_end || span.end - span.offset < head_bytes ||
      indexed.compressed_size > span.end - span.offset - head_bytes) {
    return false;
  }
  span.chunk.records = file.subspan(static_cast<std::size_t>(span.offset + head_bytes),
                                    static_cast<std::size_t>(indexed.compressed_size));
  return true;
}

/// Takes the records between the chunks that no index lists: false when one is a message, a chunk,
/// or not a record, so that the summary is incomplete.
bool takeBetween(ByteView file, std::vector<FileRange> ranges, std::uint64_t data_end,
                 LogIndex& out) {
  ranges.push_back({data_end, data_end});
  std::ranges::sort(ranges, {}, &FileRange::from);
  mcap::RecordStepper steps(file, mcap::magic().size());
  for (const FileRange& range : ranges) {
    while (steps.position() < range.from) {
      const std::optional<mcap::Record> record = steps.next();
      if (!record || record->end() > range.from) return false;
      switch (record->opcode) {
        case Opcode::invalid:
        case Opcode::message:
        case Opcode::chunk:
        case Opcode::message_index:
          return false;
        case Opcode::attachment:
          if (!addAttachment(*record, out)) return false;
          break;
        case Opcode::metadata:
          if (!addMetadata(*record, out)) return false;
          break;
        default:
          break;
      }
    }
    // An overlap would return the same bytes twice.
    if (steps.position() > range.from) return false;
    steps.moveTo(range.to);
  }
  return true;
}

/// True when the records are at the offsets in their indexes, and match them. All of them are found
/// between the chunks.
bool indexesAgree(ByteView file, const Summary& summary) {
  for (const mcap::AttachmentIndex& index : summary.attachments) {
    const std::optional<mcap::Record> record = mcap::recordAt(file, index.offset);
    if (!record || record->opcode != Opcode::attachment ||
        record->end() - record->offset != index.length) {
      return false;
    }
  }
  for (const mcap::MetadataIndex& index : summary.metadata) {
    const std::optional<mcap::Record> record = mcap::recordAt(file, index.offset);
    mcap::Metadata metadata;
    if (!record || record->opcode != Opcode::metadata ||
        record->end() - record->offset != index.length || !mcap::parse(record->content, metadata) ||
        metadata.name != index.name) {
      return false;
    }
  }
  return true;
}

bool headersAgree(ByteView file, const std::vector<MessageSpan>& spans) {
  const SpanDecoder decoder(file);
  std::vector<DamageSpan> damage;
  for (const MessageSpan& span : spans) decoder.chunkInFile(span, damage);
  return damage.empty();
}

bool readIndexed(ByteView file, Summary& summary, std::uint64_t data_end, LogIndex& out) {
  std::vector<FileRange> ranges;
  ranges.reserve(summary.chunks.size() + 1);
  out.spans.reserve(summary.chunks.size());
  for (ChunkPlace& indexed : summary.chunks) {
    if (!place(file, indexed, data_end)) return false;
    ranges.push_back({indexed.span.offset, indexed.span.index_end});
    out.spans.push_back(std::move(indexed.span));
  }
  std::ranges::sort(out.spans, {}, &MessageSpan::offset);
  mcap::ExpansionBudget budget(file.size());
  for (MessageSpan& span : out.spans) span.over_budget = !budget.take(span.chunk);
  if (const std::optional<mcap::Record> first = mcap::recordAt(file, mcap::magic().size())) {
    if (first->opcode == Opcode::header) mcap::parse(first->content, out.header);
  }
  const mcap::Statistics& statistics = *summary.statistics;
  return indexesAgree(file, summary) && takeBetween(file, std::move(ranges), data_end, out) &&
         out.attachments.size() == statistics.attachment_count &&
         out.metadata.size() == statistics.metadata_count;
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
    return std::nullopt;  // not a whole file: the walk finds where it ends
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
  // A valid file may omit any of it; then the walk has to find it.
  if (!isComplete(summary)) return std::nullopt;

  LogIndex index;
  for (const mcap::Channel& channel : summary.channels) {
    if (!addChannel(index, channel)) return faulty("the summary defines a channel twice");
  }
  for (mcap::Schema& schema : summary.schemas) addSchema(index, std::move(schema));
  for (const auto& [id, count] : summary.statistics->channel_message_counts) {
    index.message_counts.emplace(id, count);
  }
  if (!readIndexed(file, summary, data_end, index)) {
    return faulty("the summary does not agree with the file");
  }
  // Without a checksum, a summary that disagrees with a chunk proves nothing against the chunk.
  if (footer.summary_crc == 0 && !headersAgree(file, index.spans)) {
    return faulty("the summary, which has no checksum, does not agree with the file");
  }
  index.closed = true;
  return index;
}

}  // namespace rocinante
