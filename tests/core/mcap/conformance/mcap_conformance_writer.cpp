// mcap_conformance_writer FILE.json: the MCAP file that the JSON describes, on standard output.

#include <cstdio>
#include <set>

#include "core/mcap/writer.h"
#include "tests/core/mcap/conformance/record_json.h"

namespace rocinante::test {
namespace {

/// One record of the JSON, by the names of its fields.
class Description {
 public:
  explicit Description(const Json& record) : type_(record.at("type")) {
    for (const Json& field : record.at("fields")) fields_[field.at(0)] = field.at(1);
  }
  const std::string& type() const { return type_; }
  std::string text(const char* name) const { return fields_.at(name); }
  std::uint64_t number(const char* name) const { return std::stoull(text(name)); }
  template <class T>
  T number(const char* name) const {
    return static_cast<T>(number(name));
  }
  Bytes bytes(const char* name) const {
    Bytes out;
    for (const Json& byte : fields_.at(name)) {
      out.push_back(static_cast<std::byte>(std::stoi(byte.get<std::string>())));
    }
    return out;
  }
  std::map<std::string, std::string> map(const char* name) const { return fields_.at(name); }

 private:
  std::string type_;
  std::map<std::string, Json> fields_;
};

mcap::WriterOptions optionsOf(const Json& variant) {
  const std::set<std::string> features = variant.at("features");
  mcap::WriterOptions options;
  options.zstd_level.reset();
  options.chunked = features.contains("ch");
  options.message_indexes = features.contains("mx");
  options.chunk_indexes = features.contains("chx");
  options.attachment_indexes = features.contains("ax");
  options.metadata_indexes = features.contains("mdx");
  options.statistics = features.contains("st");
  options.repeat_schemas = features.contains("rsh");
  options.repeat_channels = features.contains("rch");
  options.summary_offsets = features.contains("sum");
  return options;
}

Status writeRecord(mcap::Writer& writer, const Description& record) {
  if (record.type() == "Schema") {
    writer.addSchema({record.number<std::uint16_t>("id"), record.text("name"),
                      record.text("encoding"), record.bytes("data")});
  } else if (record.type() == "Channel") {
    writer.addChannel({record.number<std::uint16_t>("id"),
                       record.number<std::uint16_t>("schema_id"), record.text("topic"),
                       record.text("message_encoding"), record.map("metadata")});
  } else if (record.type() == "Message") {
    const Bytes data = record.bytes("data");
    return writer.write({record.number<std::uint16_t>("channel_id"),
                         record.number<std::uint32_t>("sequence"), record.number("log_time"),
                         record.number("publish_time"), data});
  } else if (record.type() == "Attachment") {
    const Bytes data = record.bytes("data");
    mcap::Attachment attachment;
    attachment.log_time = record.number("log_time");
    attachment.create_time = record.number("create_time");
    attachment.name = record.text("name");
    attachment.media_type = record.text("media_type");
    attachment.data = data;
    return writer.writeAttachment(attachment);
  } else if (record.type() == "Metadata") {
    return writer.writeMetadata({record.text("name"), record.map("metadata")});
  }
  return {};
}

int writeFile(const char* path) {
  const Json json = Json::parse(readWhole(path));
  Bytes file;
  Result<mcap::Writer> writer = Error{ErrorKind::damaged, "the first record is no Header", path};
  for (const Json& each : json.at("records")) {
    const Description record(each);
    if (record.type() == "DataEnd") break;  // the writer makes the rest itself
    if (record.type() == "Header") {
      writer = mcap::Writer::start(makeMemorySink(file), optionsOf(json.at("meta").at("variant")),
                                   {record.text("profile"), record.text("library")});
    }
    if (!writer || !writeRecord(*writer, record)) return 1;
  }
  if (!writer || !writer->finish()) return 1;
  return std::fwrite(file.data(), 1, file.size(), stdout) == file.size() ? 0 : 1;
}

}  // namespace
}  // namespace rocinante::test

int main(int argc, char** argv) { return argc == 2 ? rocinante::test::writeFile(argv[1]) : 2; }
