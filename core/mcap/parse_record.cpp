#include "core/mcap/parse_record.h"

#include "core/mcap/byte_cursor.h"
#include "core/mcap/record_fields.h"

namespace rocinante::mcap {
namespace {

/// Reads one field after another.
struct FieldReader {
  ByteCursor cursor;
  bool maps_fit = true;  ///< the pairs of each map fill its bytes exactly

  template <std::unsigned_integral T>
  void take(T& number) {
    number = cursor.number<T>();
  }
  void take(Opcode& opcode) { opcode = static_cast<Opcode>(cursor.number<std::uint8_t>()); }
  void take(std::string& text) { text = cursor.string(); }
  void take(std::string_view& text) { text = cursor.string(); }
  void take(Bytes& bytes) {
    const ByteView data = cursor.bytes32();
    bytes.assign(data.begin(), data.end());
  }
  void take(ByteView& bytes) { bytes = cursor.bytes64(); }
  /// A repeated key keeps its first value.
  template <class Key, class Value>
  void take(std::map<Key, Value>& map) {
    map.clear();
    FieldReader pairs{ByteCursor(cursor.bytes32())};
    while (pairs.cursor.ok() && pairs.cursor.remaining() > 0) {
      Key key;
      Value value;
      pairs.take(key);
      pairs.take(value);
      if (pairs.cursor.ok()) map.emplace(std::move(key), std::move(value));
    }
    maps_fit = maps_fit && pairs.cursor.ok();
  }

  std::optional<std::size_t> consumed() const {
    if (!cursor.ok() || !maps_fit) return std::nullopt;
    return cursor.position();
  }
};

template <class Record>
std::optional<std::size_t> parseFields(ByteView content, Record& out) {
  FieldReader reader{ByteCursor(content)};
  useFields(out, [&](auto&... fields) { (reader.take(fields), ...); });
  return reader.consumed();
}

/// For the frozen records, which must not have anything after their known fields.
template <class Record>
std::optional<std::size_t> parseWhole(ByteView content, Record& out) {
  const std::optional<std::size_t> used = parseFields(content, out);
  return used == content.size() ? used : std::nullopt;
}

}  // namespace

std::optional<std::size_t> parse(ByteView content, Header& out) {
  return parseFields(content, out);
}
std::optional<std::size_t> parse(ByteView content, Schema& out) {
  return parseFields(content, out);
}
std::optional<std::size_t> parse(ByteView content, Channel& out) {
  return parseFields(content, out);
}
std::optional<std::size_t> parse(ByteView content, Chunk& out) { return parseFields(content, out); }
std::optional<std::size_t> parse(ByteView content, ChunkIndex& out) {
  return parseFields(content, out);
}
std::optional<std::size_t> parse(ByteView content, AttachmentIndex& out) {
  return parseFields(content, out);
}
std::optional<std::size_t> parse(ByteView content, Statistics& out) {
  return parseFields(content, out);
}
std::optional<std::size_t> parse(ByteView content, Metadata& out) {
  return parseFields(content, out);
}
std::optional<std::size_t> parse(ByteView content, MetadataIndex& out) {
  return parseFields(content, out);
}
std::optional<std::size_t> parse(ByteView content, SummaryOffset& out) {
  return parseFields(content, out);
}
std::optional<std::size_t> parse(ByteView content, Footer& out) { return parseWhole(content, out); }
std::optional<std::size_t> parse(ByteView content, DataEnd& out) {
  return parseWhole(content, out);
}

std::optional<std::size_t> parse(ByteView content, Attachment& out) {
  const std::optional<std::size_t> used = parseFields(content, out);
  if (!used || content.size() - *used < sizeof(out.crc)) return std::nullopt;
  out.checked = content.first(*used);
  ByteCursor behind(content.subspan(*used));
  out.crc = behind.number<std::uint32_t>();
  return *used + behind.position();
}

std::optional<std::size_t> parse(ByteView content, Message& out) {
  ByteCursor cursor(content);
  out.channel_id = cursor.number<std::uint16_t>();
  out.sequence = cursor.number<std::uint32_t>();
  out.log_time = cursor.number<std::uint64_t>();
  out.publish_time = cursor.number<std::uint64_t>();
  out.data = cursor.take(cursor.remaining());
  if (!cursor.ok()) return std::nullopt;
  return cursor.position();
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
  if (!cursor.ok()) return std::nullopt;
  return cursor.position();
}

std::optional<IndexEntries> indexEntries(ByteView content) {
  ByteCursor cursor(content);
  IndexEntries index;
  index.channel = cursor.number<std::uint16_t>();
  index.entries = cursor.bytes32();
  if (!cursor.ok() || index.entries.size() % IndexEntries::kEntryBytes != 0) return std::nullopt;
  return index;
}

}  // namespace rocinante::mcap
