#include "recorder/doctor/doctor_facts.h"

#include <fmt/format.h>

#include <set>

#include "core/base/hash.h"
#include "core/base/plain_text.h"
#include "core/mcap/append_record.h"
#include "core/mcap/byte_cursor.h"
#include "core/mcap/parse_record.h"

namespace rocinante {

void checkText(DoctorReport& report, std::uint64_t offset, std::string_view text) {
  if (isUtf8(bytesOf(text))) return;
  report.add("utf8", offset, fmt::format("\"{}\" is not UTF-8", plainText(text.substr(0, 100))));
}

void checkStringMap(DoctorReport& report, std::uint64_t offset, ByteView content) {
  mcap::ByteCursor outside(content);
  mcap::ByteCursor cursor(outside.bytes32());
  std::set<std::string_view> keys;
  while (cursor.ok() && cursor.remaining() > 0) {
    const std::string_view key = cursor.string();
    const std::string_view value = cursor.string();
    if (!cursor.ok()) return;
    checkText(report, offset, key);
    checkText(report, offset, value);
    if (!keys.insert(key).second) {
      report.add("map-key", offset,
                 fmt::format("the key \"{}\" appears twice", plainText(key.substr(0, 100))));
    }
  }
}

void checkNumberMap(DoctorReport& report, std::uint64_t offset, ByteView content) {
  mcap::ByteCursor outside(content);
  mcap::ByteCursor cursor(outside.bytes32());
  std::set<std::uint16_t> keys;
  while (cursor.ok() && cursor.remaining() > 0) {
    const auto key = cursor.number<std::uint16_t>();
    cursor.number<std::uint64_t>();
    if (cursor.ok() && !keys.insert(key).second) {
      report.add("map-key", offset, fmt::format("the key {} appears twice", key));
    }
  }
}

template <class T>
bool Definitions::define(std::map<std::uint16_t, Digest>& known, std::uint16_t id,
                         const T& definition) {
  // Normalised as we would write it, because the order of a map's keys is irrelevant.
  scratch_.clear();
  mcap::append(scratch_, definition);
  const Digest digest = xxh3(scratch_);
  const auto [place, is_new] = known.try_emplace(id, digest);
  return is_new || place->second == digest;
}

std::optional<mcap::Channel> Definitions::addChannel(const mcap::Record& record,
                                                     std::uint64_t offset) {
  mcap::Channel channel;
  if (!mcap::parse(record.content, channel)) {
    report_.add("record-fields", offset, "the lengths in a Channel do not fit into it");
    return std::nullopt;
  }
  if (!hasChannel(channel.id)) {
    checkText(report_, offset, channel.topic);
    checkText(report_, offset, channel.message_encoding);
    const std::size_t before = 4 + 4 + channel.topic.size() + 4 + channel.message_encoding.size();
    checkStringMap(report_, offset, record.content.subspan(before));
    if (channel.schema_id != 0 && !hasSchema(channel.schema_id)) {
      report_.add("channel-schema", offset,
                  fmt::format("channel {} names schema {}, which was not defined before",
                              channel.id, channel.schema_id));
    }
  }
  if (!define(channels_, channel.id, channel)) {
    report_.add("redefined", offset,
                fmt::format("channel {} is defined again with other fields", channel.id));
  }
  return channel;
}

bool Definitions::addSchema(const mcap::Record& record, std::uint64_t offset) {
  mcap::Schema schema;
  if (!mcap::parse(record.content, schema)) {
    report_.add("record-fields", offset, "the lengths in a Schema do not fit into it");
    return false;
  }
  if (schema.id == 0) {
    report_.add("schema-id", offset, "a Schema has id 0, which means \"no schema\"");
    return false;
  }
  if (!hasSchema(schema.id)) {
    checkText(report_, offset, schema.name);
    checkText(report_, offset, schema.encoding);
    if (schema.encoding.empty() && !schema.data.empty()) {
      report_.add("schema-encoding", offset,
                  fmt::format("schema {} has data and no encoding", schema.id));
    }
  }
  if (!define(schemas_, schema.id, schema)) {
    report_.add("redefined", offset,
                fmt::format("schema {} is defined again with other fields", schema.id));
  }
  return true;
}

}  // namespace rocinante
