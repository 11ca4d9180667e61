#include "core/foreign/decode/field_reader.h"
#include "core/foreign/protobuf/protobuf_schema.h"

namespace rocinante::decode {
namespace {

std::vector<std::string> pathsOf(const Decoder& decoder) {
  std::vector<std::string> paths;
  for (const Field& field : decoder.fields) paths.push_back(field.path);
  return paths;
}

class ProtobufReader final : public FieldReader {
 public:
  explicit ProtobufReader(const Decoder& decoder)
      : paths_(pathsOf(decoder)), message_(decoder.schema, paths_) {}

  bool read(ByteView datagram, std::span<FieldValue> values) override {
    const std::string_view fault = message_.read(datagram);
    if (!fault.empty()) return refuse(fault);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const RocinanteProtobufValue& value = message_.values()[i];
      if (value.kind == 1) values[i] = FieldValue::of(value.number);
      if (value.kind == 2) values[i] = FieldValue::of({value.text, value.text_bytes});
    }
    return true;
  }

  std::vector<FoundField> undeclared(ByteView datagram, std::size_t most) override {
    std::vector<FoundField> found;
    for (protobuf::NamedValue& each : message_.others(datagram, paths_, most)) {
      found.push_back({std::move(each.path), std::move(each.value)});
    }
    return found;
  }

 private:
  std::vector<std::string> paths_;
  protobuf::Reader message_;
};

}  // namespace

std::unique_ptr<FieldReader> makeProtobufReader(const Decoder& decoder) {
  return std::make_unique<ProtobufReader>(decoder);
}

}  // namespace rocinante::decode
