#include "core/foreign/ros/ros1_record.h"

#include <algorithm>

namespace rocinante::ros {
namespace {

/// u32 length, then that many bytes; moves `at` behind them.
std::optional<ByteView> blockAt(ByteView bytes, std::size_t& at) {
  std::uint32_t length = 0;
  if (at > bytes.size() || bytes.size() - at < sizeof length) return std::nullopt;
  std::memcpy(&length, bytes.data() + at, sizeof length);
  if (length > bytes.size() - at - sizeof length) return std::nullopt;
  const ByteView block = bytes.subspan(at + sizeof length, length);
  at += sizeof length + length;
  return block;
}

}  // namespace

Ros1Fields ros1Fields(ByteView header) {
  Ros1Fields fields;
  for (std::size_t at = 0; at < header.size();) {
    const std::optional<ByteView> field = blockAt(header, at);
    if (!field) break;
    const std::string_view text = textOf(*field);
    const std::size_t equals = text.find('=');
    if (equals == text.npos) break;
    fields.emplace_back(text.substr(0, equals), field->subspan(equals + 1));
  }
  return fields;
}

std::optional<ByteView> ros1Field(const Ros1Fields& fields, std::string_view name) {
  for (const auto& [each, value] : fields) {
    if (each == name) return value;
  }
  return std::nullopt;
}

std::optional<Ros1Record> ros1RecordAt(ByteView bytes, std::size_t offset) {
  std::optional<Ros1Record> record = wholeOrCutRos1RecordAt(bytes, offset);
  if (record && record->is_cut) return std::nullopt;
  return record;
}

std::optional<Ros1Record> wholeOrCutRos1RecordAt(ByteView bytes, std::size_t offset) {
  Ros1Record record;
  record.offset = offset;
  record.end = offset;
  const std::optional<ByteView> header = blockAt(bytes, record.end);
  if (!header) return std::nullopt;
  record.fields = ros1Fields(*header);
  const std::optional<std::uint8_t> op = record.number<std::uint8_t>("op");
  if (!op) return std::nullopt;
  record.op = Ros1Op{*op};
  const ByteView rest = bytes.subspan(record.end);
  if (const std::optional<ByteView> data = blockAt(bytes, record.end)) {
    record.data = *data;
  } else {
    record.is_cut = true;
    record.data = rest.subspan(std::min(rest.size(), sizeof(std::uint32_t)));
    record.end = bytes.size();
  }
  return record;
}

}  // namespace rocinante::ros
