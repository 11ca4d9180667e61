#include "core/mcap/append_record.h"

#include <type_traits>

#include "core/base/hash.h"
#include "core/mcap/byte_cursor.h"

namespace rocinante::mcap {
namespace {

/// Writes the prefix, and the length once the content is complete.
class RecordScope {
 public:
  RecordScope(Bytes& out, Opcode opcode) : out_(out), start_(out.size()) {
    out_.push_back(static_cast<std::byte>(opcode));
    appendNumber(out_, std::uint64_t{0});
  }
  ~RecordScope() {
    const std::uint64_t length = out_.size() - start_ - kPrefixBytes;
    std::memcpy(out_.data() + start_ + 1, &length, sizeof(length));
  }
  RecordScope(const RecordScope&) = delete;
  RecordScope& operator=(const RecordScope&) = delete;

  std::size_t contentStart() const { return start_ + kPrefixBytes; }

 private:
  Bytes& out_;
  std::size_t start_;
};

/// A map's length counts its bytes, not its pairs.
template <class AppendPairs>
void appendMap(Bytes& out, AppendPairs append_pairs) {
  const std::size_t start = out.size();
  appendNumber(out, std::uint32_t{0});
  append_pairs();
  const auto length = static_cast<std::uint32_t>(out.size() - start - sizeof(std::uint32_t));
  std::memcpy(out.data() + start, &length, sizeof(length));
}

void appendStringMap(Bytes& out, const std::map<std::string, std::string>& map) {
  appendMap(out, [&] {
    for (const auto& [key, value] : map) {
      appendString(out, key);
      appendString(out, value);
    }
  });
}

void appendNumberMap(Bytes& out, const std::map<std::uint16_t, std::uint64_t>& map) {
  appendMap(out, [&] {
    for (const auto& [key, value] : map) {
      appendNumber(out, key);
      appendNumber(out, value);
    }
  });
}

}  // namespace

void append(Bytes& out, const Header& record) {
  const RecordScope scope(out, Opcode::header);
  appendString(out, record.profile);
  appendString(out, record.library);
}

void append(Bytes& out, const Footer& record) {
  const RecordScope scope(out, Opcode::footer);
  appendNumber(out, record.summary_start);
  appendNumber(out, record.summary_offset_start);
  appendNumber(out, record.summary_crc);
}

void append(Bytes& out, const Schema& record) {
  const RecordScope scope(out, Opcode::schema);
  appendNumber(out, record.id);
  appendString(out, record.name);
  appendString(out, record.encoding);
  appendNumber(out, static_cast<std::uint32_t>(record.data.size()));
  appendBytes(out, record.data);
}

void append(Bytes& out, const Channel& record) {
  const RecordScope scope(out, Opcode::channel);
  appendNumber(out, record.id);
  appendNumber(out, record.schema_id);
  appendString(out, record.topic);
  appendString(out, record.message_encoding);
  appendStringMap(out, record.metadata);
}

void append(Bytes& out, const Message& record) {
  // Written once per datagram: the fixed part is prepared first, so that it costs one insertion.
  std::byte head[kPrefixBytes + kMessageHeaderBytes];
  const std::uint64_t length = kMessageHeaderBytes + record.data.size();
  head[0] = static_cast<std::byte>(Opcode::message);
  std::memcpy(head + 1, &length, 8);
  std::memcpy(head + 9, &record.channel_id, 2);
  std::memcpy(head + 11, &record.sequence, 4);
  std::memcpy(head + 15, &record.log_time, 8);
  std::memcpy(head + 23, &record.publish_time, 8);
  out.insert(out.end(), head, head + sizeof(head));
  appendBytes(out, record.data);
}

void append(Bytes& out, const Chunk& record) {
  const RecordScope scope(out, Opcode::chunk);
  appendNumber(out, record.message_start_time);
  appendNumber(out, record.message_end_time);
  appendNumber(out, record.uncompressed_size);
  appendNumber(out, record.uncompressed_crc);
  appendString(out, record.compression);
  appendNumber(out, std::uint64_t{record.records.size()});
  appendBytes(out, record.records);
}

void append(Bytes& out, const MessageIndex& record) {
  const RecordScope scope(out, Opcode::message_index);
  appendNumber(out, record.channel_id);
  appendNumber(out, static_cast<std::uint32_t>(record.records.size() * 16));
  // A pair has the same layout in memory and in the file.
  using Pair = decltype(record.records)::value_type;
  static_assert(sizeof(Pair) == 16 && std::is_standard_layout_v<Pair>);
  appendBytes(out, std::as_bytes(std::span(record.records)));
}

void append(Bytes& out, const ChunkIndex& record) {
  const RecordScope scope(out, Opcode::chunk_index);
  appendNumber(out, record.message_start_time);
  appendNumber(out, record.message_end_time);
  appendNumber(out, record.chunk_start_offset);
  appendNumber(out, record.chunk_length);
  appendNumberMap(out, record.message_index_offsets);
  appendNumber(out, record.message_index_length);
  appendString(out, record.compression);
  appendNumber(out, record.compressed_size);
  appendNumber(out, record.uncompressed_size);
}

void append(Bytes& out, const Attachment& record) {
  const RecordScope scope(out, Opcode::attachment);
  appendNumber(out, record.log_time);
  appendNumber(out, record.create_time);
  appendString(out, record.name);
  appendString(out, record.media_type);
  appendNumber(out, std::uint64_t{record.data.size()});
  appendBytes(out, record.data);
  appendNumber(out, crc32(ByteView(out).subspan(scope.contentStart())));
}

void append(Bytes& out, const AttachmentIndex& record) {
  const RecordScope scope(out, Opcode::attachment_index);
  appendNumber(out, record.offset);
  appendNumber(out, record.length);
  appendNumber(out, record.log_time);
  appendNumber(out, record.create_time);
  appendNumber(out, record.data_size);
  appendString(out, record.name);
  appendString(out, record.media_type);
}

void append(Bytes& out, const Statistics& record) {
  const RecordScope scope(out, Opcode::statistics);
  appendNumber(out, record.message_count);
  appendNumber(out, record.schema_count);
  appendNumber(out, record.channel_count);
  appendNumber(out, record.attachment_count);
  appendNumber(out, record.metadata_count);
  appendNumber(out, record.chunk_count);
  appendNumber(out, record.message_start_time);
  appendNumber(out, record.message_end_time);
  appendNumberMap(out, record.channel_message_counts);
}

void append(Bytes& out, const Metadata& record) {
  const RecordScope scope(out, Opcode::metadata);
  appendString(out, record.name);
  appendStringMap(out, record.metadata);
}

void append(Bytes& out, const MetadataIndex& record) {
  const RecordScope scope(out, Opcode::metadata_index);
  appendNumber(out, record.offset);
  appendNumber(out, record.length);
  appendString(out, record.name);
}

void append(Bytes& out, const SummaryOffset& record) {
  const RecordScope scope(out, Opcode::summary_offset);
  appendNumber(out, static_cast<std::uint8_t>(record.group_opcode));
  appendNumber(out, record.group_start);
  appendNumber(out, record.group_length);
}

void append(Bytes& out, const DataEnd& record) {
  const RecordScope scope(out, Opcode::data_end);
  appendNumber(out, record.data_section_crc);
}

}  // namespace rocinante::mcap
