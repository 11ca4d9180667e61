#include "tests/core/mcap/conformance/record_json.h"

#include <cstdio>
#include <cstdlib>

#include "core/base/atomic_file.h"
#include "core/mcap/parse_record.h"

namespace rocinante::test {
namespace {

Json valueOf(const std::string& text) { return text; }
Json valueOf(std::uint64_t number) { return std::to_string(number); }
Json valueOf(ByteView bytes) {
  Json out = Json::array();
  for (const std::byte byte : bytes) out.push_back(std::to_string(std::to_integer<int>(byte)));
  return out;
}
Json valueOf(const std::map<std::string, std::string>& map) {
  Json out = Json::object();
  for (const auto& [key, value] : map) out[key] = value;
  return out;
}
Json valueOf(const std::map<std::uint16_t, std::uint64_t>& map) {
  Json out = Json::object();
  for (const auto& [key, value] : map) out[std::to_string(key)] = std::to_string(value);
  return out;
}

class Fields {
 public:
  explicit Fields(const char* type) : type_(type) {}
  template <class T>
  Fields& add(const char* name, const T& value) {
    fields_.push_back(Json::array({name, valueOf(value)}));
    return *this;
  }
  Json json() const { return {{"type", type_}, {"fields", fields_}}; }

 private:
  const char* type_;
  Json fields_ = Json::array();
};

Json jsonOf(const mcap::Header& r) {
  return Fields("Header").add("library", r.library).add("profile", r.profile).json();
}
Json jsonOf(const mcap::Footer& r) {
  return Fields("Footer")
      .add("summary_crc", std::uint64_t{r.summary_crc})
      .add("summary_offset_start", r.summary_offset_start)
      .add("summary_start", r.summary_start)
      .json();
}
Json jsonOf(const mcap::Schema& r) {
  return Fields("Schema")
      .add("data", ByteView(r.data))
      .add("encoding", r.encoding)
      .add("id", std::uint64_t{r.id})
      .add("name", r.name)
      .json();
}
Json jsonOf(const mcap::Channel& r) {
  return Fields("Channel")
      .add("id", std::uint64_t{r.id})
      .add("message_encoding", r.message_encoding)
      .add("metadata", r.metadata)
      .add("schema_id", std::uint64_t{r.schema_id})
      .add("topic", r.topic)
      .json();
}
Json jsonOf(const mcap::Message& r) { return messageJson(r); }
Json jsonOf(const mcap::ChunkIndex& r) {
  return Fields("ChunkIndex")
      .add("chunk_length", r.chunk_length)
      .add("chunk_start_offset", r.chunk_start_offset)
      .add("compressed_size", r.compressed_size)
      .add("compression", r.compression)
      .add("message_end_time", r.message_end_time)
      .add("message_index_length", r.message_index_length)
      .add("message_index_offsets", r.message_index_offsets)
      .add("message_start_time", r.message_start_time)
      .add("uncompressed_size", r.uncompressed_size)
      .json();
}
Json jsonOf(const mcap::Attachment& r) {
  return Fields("Attachment")
      .add("create_time", r.create_time)
      .add("data", r.data)
      .add("log_time", r.log_time)
      .add("media_type", r.media_type)
      .add("name", r.name)
      .json();
}
Json jsonOf(const mcap::AttachmentIndex& r) {
  return Fields("AttachmentIndex")
      .add("create_time", r.create_time)
      .add("data_size", r.data_size)
      .add("length", r.length)
      .add("log_time", r.log_time)
      .add("media_type", r.media_type)
      .add("name", r.name)
      .add("offset", r.offset)
      .json();
}
Json jsonOf(const mcap::Statistics& r) {
  return Fields("Statistics")
      .add("attachment_count", std::uint64_t{r.attachment_count})
      .add("channel_count", std::uint64_t{r.channel_count})
      .add("channel_message_counts", r.channel_message_counts)
      .add("chunk_count", std::uint64_t{r.chunk_count})
      .add("message_count", r.message_count)
      .add("message_end_time", r.message_end_time)
      .add("message_start_time", r.message_start_time)
      .add("metadata_count", std::uint64_t{r.metadata_count})
      .add("schema_count", std::uint64_t{r.schema_count})
      .json();
}
Json jsonOf(const mcap::Metadata& r) {
  return Fields("Metadata").add("metadata", r.metadata).add("name", r.name).json();
}
Json jsonOf(const mcap::MetadataIndex& r) {
  return Fields("MetadataIndex")
      .add("length", r.length)
      .add("name", r.name)
      .add("offset", r.offset)
      .json();
}
Json jsonOf(const mcap::SummaryOffset& r) {
  return Fields("SummaryOffset")
      .add("group_length", r.group_length)
      .add("group_opcode", static_cast<std::uint64_t>(r.group_opcode))
      .add("group_start", r.group_start)
      .json();
}
Json jsonOf(const mcap::DataEnd& r) {
  return Fields("DataEnd").add("data_section_crc", std::uint64_t{r.data_section_crc}).json();
}

template <class T>
std::optional<Json> read(ByteView content) {
  T record;
  if (!mcap::parse(content, record)) {
    std::fputs("a record is malformed\n", stderr);
    std::exit(1);
  }
  return std::optional<Json>(std::in_place, jsonOf(record));
}

}  // namespace

Json messageJson(const mcap::Message& r) {
  return Fields("Message")
      .add("channel_id", std::uint64_t{r.channel_id})
      .add("data", r.data)
      .add("log_time", r.log_time)
      .add("publish_time", r.publish_time)
      .add("sequence", std::uint64_t{r.sequence})
      .json();
}

std::optional<Json> recordJson(const mcap::Record& record) {
  using mcap::Opcode;
  switch (record.opcode) {
    case Opcode::header:
      return read<mcap::Header>(record.content);
    case Opcode::footer:
      return read<mcap::Footer>(record.content);
    case Opcode::schema:
      return read<mcap::Schema>(record.content);
    case Opcode::channel:
      return read<mcap::Channel>(record.content);
    case Opcode::message:
      return read<mcap::Message>(record.content);
    case Opcode::chunk_index:
      return read<mcap::ChunkIndex>(record.content);
    case Opcode::attachment:
      return read<mcap::Attachment>(record.content);
    case Opcode::attachment_index:
      return read<mcap::AttachmentIndex>(record.content);
    case Opcode::statistics:
      return read<mcap::Statistics>(record.content);
    case Opcode::metadata:
      return read<mcap::Metadata>(record.content);
    case Opcode::metadata_index:
      return read<mcap::MetadataIndex>(record.content);
    case Opcode::summary_offset:
      return read<mcap::SummaryOffset>(record.content);
    case Opcode::data_end:
      return read<mcap::DataEnd>(record.content);
    case Opcode::invalid:
    case Opcode::chunk:
    case Opcode::message_index:
      break;
  }
  return std::nullopt;
}

std::string readWhole(const char* path) {
  Result<std::string> text = readFile(path);
  if (!text) {
    std::fprintf(stderr, "%s\n", text.error().text().c_str());
    std::exit(2);
  }
  return std::move(*text);
}

}  // namespace rocinante::test
