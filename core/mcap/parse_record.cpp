#include "core/mcap/parse_record.h"

#include "core/mcap/byte_cursor.h"

namespace rocinante::mcap {
namespace {

std::optional<std::size_t> consumed(const ByteCursor& cursor) {
  if (!cursor.ok()) return std::nullopt;
  return cursor.position();
}

/// For the frozen records, which must not have anything after their known fields.
std::optional<std::size_t> consumedWhole(const ByteCursor& cursor) {
  if (!cursor.ok() || cursor.remaining() != 0) return std::nullopt;
  return cursor.position();
}

/// False when the pairs do not fill the map's bytes exactly. A repeated key keeps its first value.
bool readStringMap(ByteView bytes, std::map<std::string, std::string>& out) {
  ByteCursor cursor(bytes);
  while (cursor.ok() && cursor.remaining() > 0) {
    const std::string_view key = cursor.string();
    const std::string_view value = cursor.string();
    if (cursor.ok()) out.emplace(key, value);
  }
  return cursor.ok();
}

bool readNumberMap(ByteView bytes, std::map<std::uint16_t, std::uint64_t>& out) {
  ByteCursor cursor(bytes);
  while (cursor.ok() && cursor.remaining() > 0) {
    const auto key = cursor.number<std::uint16_t>();
    const auto value = cursor.number<std::uint64_t>();
    if (cursor.ok()) out.emplace(key, value);
  }
  return cursor.ok();
}

}  // namespace

std::optional<std::size_t> parse(ByteView content, Header& out) {
  ByteCursor cursor(content);
  out.profile = cursor.string();
  out.library = cursor.string();
  return consumed(cursor);
}

std::optional<std::size_t> parse(ByteView content, Footer& out) {
  ByteCursor cursor(content);
  out.summary_start = cursor.number<std::uint64_t>();
  out.summary_offset_start = cursor.number<std::uint64_t>();
  out.summary_crc = cursor.number<std::uint32_t>();
  return consumedWhole(cursor);
}

std::optional<std::size_t> parse(ByteView content, Schema& out) {
  ByteCursor cursor(content);
  out.id = cursor.number<std::uint16_t>();
  out.name = cursor.string();
  out.encoding = cursor.string();
  const ByteView data = cursor.bytes32();
  out.data.assign(data.begin(), data.end());
  return consumed(cursor);
}

std::optional<std::size_t> parse(ByteView content, Channel& out) {
  ByteCursor cursor(content);
  out.id = cursor.number<std::uint16_t>();
  out.schema_id = cursor.number<std::uint16_t>();
  out.topic = cursor.string();
  out.message_encoding = cursor.string();
  out.metadata.clear();
  if (!readStringMap(cursor.bytes32(), out.metadata)) return std::nullopt;
  return consumed(cursor);
}

std::optional<std::size_t> parse(ByteView content, Message& out) {
  ByteCursor cursor(content);
  out.channel_id = cursor.number<std::uint16_t>();
  out.sequence = cursor.number<std::uint32_t>();
  out.log_time = cursor.number<std::uint64_t>();
  out.publish_time = cursor.number<std::uint64_t>();
  out.data = cursor.take(cursor.remaining());
  return consumed(cursor);
}

std::optional<std::size_t> parse(ByteView content, Chunk& out) {
  ByteCursor cursor(content);
  out.message_start_time = cursor.number<std::uint64_t>();
  out.message_end_time = cursor.number<std::uint64_t>();
  out.uncompressed_size = cursor.number<std::uint64_t>();
  out.uncompressed_crc = cursor.number<std::uint32_t>();
  out.compression = cursor.string();
  out.records = cursor.bytes64();
  return consumed(cursor);
}

std::optional<std::size_t> parse(ByteView content, MessageIndex& out) {
  ByteCursor cursor(content);
  out.channel_id = cursor.number<std::uint16_t>();
  const ByteView records = cursor.bytes32();
  if (records.size() % 16 != 0) return std::nullopt;
  out.records.clear();
  out.records.reserve(records.size() / 16);
  for (ByteCursor each(records); each.remaining() > 0;) {
    const auto log_time = each.number<std::uint64_t>();
    const auto offset = each.number<std::uint64_t>();
    out.records.emplace_back(log_time, offset);
  }
  return consumed(cursor);
}

std::optional<IndexEntries> indexEntries(ByteView content) {
  ByteCursor cursor(content);
  IndexEntries index;
  index.channel = cursor.number<std::uint16_t>();
  index.entries = cursor.bytes32();
  if (!cursor.ok() || index.entries.size() % IndexEntries::kEntryBytes != 0) return std::nullopt;
  return index;
}

std::optional<std::size_t> parse(ByteView content, ChunkIndex& out) {
  ByteCursor cursor(content);
  out.message_start_time = cursor.number<std::uint64_t>();
  out.message_end_time = cursor.number<std::uint64_t>();
  out.chunk_start_offset = cursor.number<std::uint64_t>();
  out.chunk_length = cursor.number<std::uint64_t>();
  out.message_index_offsets.clear();
  if (!readNumberMap(cursor.bytes32(), out.message_index_offsets)) return std::nullopt;
  out.message_index_length = cursor.number<std::uint64_t>();
  out.compression = cursor.string();
  out.compressed_size = cursor.number<std::uint64_t>();
  out.uncompressed_size = cursor.number<std::uint64_t>();
  return consumed(cursor);
}

std::optional<std::size_t> parse(ByteView content, Attachment& out) {
  ByteCursor cursor(content);
  out.log_time = cursor.number<std::uint64_t>();
  out.create_time = cursor.number<std::uint64_t>();
  out.name = cursor.string();
  out.media_type = cursor.string();
  out.data = cursor.bytes64();
  out.checked = content.first(cursor.position());
  out.crc = cursor.number<std::uint32_t>();
  return consumed(cursor);
}

std::optional<std::size_t> parse(ByteView content, AttachmentIndex& out) {
  ByteCursor cursor(content);
  out.offset = cursor.number<std::uint64_t>();
  out.length = cursor.number<std::uint64_t>();
  out.log_time = cursor.number<std::uint64_t>();
  out.create_time = cursor.number<std::uint64_t>();
  out.data_size = cursor.number<std::uint64_t>();
  out.name = cursor.string();
  out.media_type = cursor.string();
  return consumed(cursor);
}

std::optional<std::size_t> parse(ByteView content, Statistics& out) {
  ByteCursor cursor(content);
  out.message_count = cursor.number<std::uint64_t>();
  out.schema_count = cursor.number<std::uint16_t>();
  out.channel_count = cursor.number<std::uint32_t>();
  out.attachment_count = cursor.number<std::uint32_t>();
  out.metadata_count = cursor.number<std::uint32_t>();
  out.chunk_count = cursor.number<std::uint32_t>();
  out.message_start_time = cursor.number<std::uint64_t>();
  out.message_end_time = cursor.number<std::uint64_t>();
  out.channel_message_counts.clear();
  if (!readNumberMap(cursor.bytes32(), out.channel_message_counts)) return std::nullopt;
  return consumed(cursor);
}

std::optional<std::size_t> parse(ByteView content, Metadata& out) {
  ByteCursor cursor(content);
  out.name = cursor.string();
  out.metadata.clear();
  if (!readStringMap(cursor.bytes32(), out.metadata)) return std::nullopt;
  return consumed(cursor);
}

std::optional<std::size_t> parse(ByteView content, MetadataIndex& out) {
  ByteCursor cursor(content);
  out.offset = cursor.number<std::uint64_t>();
  out.length = cursor.number<std::uint64_t>();
  out.name = cursor.string();
  return consumed(cursor);
}

std::optional<std::size_t> parse(ByteView content, SummaryOffset& out) {
  ByteCursor cursor(content);
  out.group_opcode = static_cast<Opcode>(cursor.number<std::uint8_t>());
  out.group_start = cursor.number<std::uint64_t>();
  out.group_length = cursor.number<std::uint64_t>();
  return consumed(cursor);
}

std::optional<std::size_t> parse(ByteView content, DataEnd& out) {
  ByteCursor cursor(content);
  out.data_section_crc = cursor.number<std::uint32_t>();
  return consumedWhole(cursor);
}

}  // namespace rocinante::mcap
