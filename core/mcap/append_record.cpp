#include "core/mcap/append_record.h"

#include <type_traits>

#include "core/base/hash.h"
#include "core/mcap/byte_cursor.h"
#include "core/mcap/record_fields.h"

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

/// Appends one field after another.
struct FieldWriter {
  Bytes& out;

  void add(std::unsigned_integral auto number) { appendNumber(out, number); }
  void add(Opcode opcode) { appendNumber(out, static_cast<std::uint8_t>(opcode)); }
  void add(std::string_view text) { appendString(out, text); }
  void add(const Bytes& bytes) { appendString(out, textOf(bytes)); }
  /// Borrowed bytes have a 64-bit length.
  void add(ByteView bytes) {
    appendNumber(out, std::uint64_t{bytes.size()});
    appendBytes(out, bytes);
  }
  /// A map's length counts its bytes, not its pairs.
  template <class Key, class Value>
  void add(const std::map<Key, Value>& map) {
    const std::size_t start = out.size();
    appendNumber(out, std::uint32_t{0});
    for (const auto& [key, value] : map) {
      add(key);
      add(value);
    }
    const auto length = static_cast<std::uint32_t>(out.size() - start - sizeof(std::uint32_t));
    std::memcpy(out.data() + start, &length, sizeof(length));
  }
};

template <class Record>
void appendFields(Bytes& out, const Record& record) {
  FieldWriter writer{out};
  useFields(record, [&](const auto&... fields) { (writer.add(fields), ...); });
}

template <class Record>
void appendRecord(Bytes& out, Opcode opcode, const Record& record) {
  const RecordScope scope(out, opcode);
  appendFields(out, record);
}

}  // namespace

void append(Bytes& out, const Header& record) { appendRecord(out, Opcode::header, record); }
void append(Bytes& out, const Footer& record) { appendRecord(out, Opcode::footer, record); }
void append(Bytes& out, const Schema& record) { appendRecord(out, Opcode::schema, record); }
void append(Bytes& out, const Channel& record) { appendRecord(out, Opcode::channel, record); }
void append(Bytes& out, const Chunk& record) { appendRecord(out, Opcode::chunk, record); }
void append(Bytes& out, const ChunkIndex& record) {
  appendRecord(out, Opcode::chunk_index, record);
}
void append(Bytes& out, const AttachmentIndex& record) {
  appendRecord(out, Opcode::attachment_index, record);
}
void append(Bytes& out, const Statistics& record) { appendRecord(out, Opcode::statistics, record); }
void append(Bytes& out, const Metadata& record) { appendRecord(out, Opcode::metadata, record); }
void append(Bytes& out, const MetadataIndex& record) {
  appendRecord(out, Opcode::metadata_index, record);
}
void append(Bytes& out, const SummaryOffset& record) {
  appendRecord(out, Opcode::summary_offset, record);
}
void append(Bytes& out, const DataEnd& record) { appendRecord(out, Opcode::data_end, record); }

void append(Bytes& out, const Attachment& record) {
  const RecordScope scope(out, Opcode::attachment);
  appendFields(out, record);
  appendNumber(out, crc32(ByteView(out).subspan(scope.contentStart())));
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

void append(Bytes& out, const MessageIndex& record) {
  const RecordScope scope(out, Opcode::message_index);
  appendNumber(out, record.channel_id);
  appendNumber(out, static_cast<std::uint32_t>(record.records.size() * 16));
  // A pair has the same layout in memory and in the file.
  using Pair = decltype(record.records)::value_type;
  static_assert(sizeof(Pair) == 16 && std::is_standard_layout_v<Pair>);
  appendBytes(out, std::as_bytes(std::span(record.records)));
}

}  // namespace rocinante::mcap
