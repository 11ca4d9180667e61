#include "core/foreign/proto/proto_schema.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "core/foreign/proto/proto_writer.h"

namespace rocinante {
namespace {

// Numbers of descriptor.proto.
enum FieldType : std::uint32_t {
  kDouble = 1,
  kInt64 = 3,
  kInt32 = 5,
  kFixed32Type = 7,
  kBool = 8,
  kString = 9,
  kMessage = 11,
  kBytesType = 12,
  kEnum = 14,
};
enum FieldLabel : std::uint32_t { kSingle = 1, kRepeated = 3 };

struct ProtoField {
  std::string name;
  std::uint32_t number = 0;
  std::uint32_t type = kMessage;
  std::string type_name;  ///< of messages and enums: with the leading point
  bool is_repeated = false;
  bool is_optional = false;
};

struct EnumValue {
  std::string name;
  std::uint32_t number = 0;
};
struct ProtoEnum {
  std::string name;
  std::vector<EnumValue> values;
};

std::vector<std::string> pieces(std::string_view text, std::string_view separator) {
  std::vector<std::string> all;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    all.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + separator.size(), text.size()));
  }
  return all;
}

/// "NAME=NUMBER".
EnumValue numbered(const std::string& text) {
  const std::size_t equals = text.find('=');
  return {text.substr(0, equals),
          static_cast<std::uint32_t>(std::strtoul(text.c_str() + equals + 1, nullptr, 10))};
}

std::vector<ProtoEnum> enumsOf(const ProtoMessage& message) {
  std::vector<ProtoEnum> enums;
  for (const std::string& line : pieces(message.enums, "; ")) {
    const std::vector<std::string> words = pieces(line, " ");
    ProtoEnum made{words[0], {}};
    for (std::size_t i = 1; i < words.size(); ++i) made.values.push_back(numbered(words[i]));
    enums.push_back(std::move(made));
  }
  return enums;
}

void setType(ProtoField& field, const std::string& type, std::string_view package,
             const ProtoMessage& message) {
  static constexpr std::pair<std::string_view, std::uint32_t> kScalars[] = {
      {"double", kDouble},   {"fixed32", kFixed32Type}, {"bool", kBool},  {"string", kString},
      {"bytes", kBytesType}, {"int64", kInt64},         {"int32", kInt32}};
  for (const auto& [name, number] : kScalars) {
    if (type == name) field.type = number;
  }
  if (field.type != kMessage) return;
  for (const ProtoEnum& each : enumsOf(message)) {
    if (each.name != type) continue;
    field.type = kEnum;
    field.type_name = "." + std::string(package) + "." + std::string(message.name) + "." + type;
    return;
  }
  const bool is_known = type == "Timestamp" || type == "Duration";
  field.type_name =
      "." + (is_known ? std::string("google.protobuf") : std::string(package)) + "." + type;
}

std::vector<ProtoField> fieldsOf(std::string_view package, const ProtoMessage& message) {
  std::vector<ProtoField> fields;
  for (const std::string& line : pieces(message.fields, "; ")) {
    std::vector<std::string> words = pieces(line, " ");
    ProtoField field;
    field.is_repeated = words[0] == "repeated";
    field.is_optional = words[0] == "optional";
    if (words.size() == 3) words.erase(words.begin());
    assert(words.size() == 2);
    EnumValue name = numbered(words[1]);
    field.name = std::move(name.name);
    field.number = name.number;
    setType(field, words[0], package, message);
    fields.push_back(std::move(field));
  }
  return fields;
}

/// ".foxglove.Vector3" -> "foxglove/Vector3.proto"; google's own files are in lower case.
std::string fileOf(const std::string& type_name) {
  if (type_name == ".google.protobuf.Timestamp") return "google/protobuf/timestamp.proto";
  if (type_name == ".google.protobuf.Duration") return "google/protobuf/duration.proto";
  std::string file = type_name.substr(1);
  std::replace(file.begin(), file.end(), '.', '/');
  return file + ".proto";
}

class DescriptorSet {
 public:
  DescriptorSet(std::string_view package, std::span<const ProtoMessage> messages)
      : package_(package), messages_(messages) {}

  /// The files that it needs come first.
  void add(const std::string& type_name) {
    const std::string file = fileOf(type_name);
    if (!added_.insert(file).second) return;
    static constexpr ProtoMessage kTimestamp{"Timestamp", "int64 seconds=1; int32 nanos=2", ""};
    static constexpr ProtoMessage kDuration{"Duration", "int64 seconds=1; int32 nanos=2", ""};
    if (type_name == ".google.protobuf.Timestamp")
      return write(file, "google.protobuf", kTimestamp);
    if (type_name == ".google.protobuf.Duration") return write(file, "google.protobuf", kDuration);
    const std::string_view name = std::string_view(type_name).substr(package_.size() + 2);
    const auto found = std::find_if(messages_.begin(), messages_.end(),
                                    [&](const ProtoMessage& each) { return each.name == name; });
    assert(found != messages_.end());
    write(file, package_, *found);
  }

  Bytes take() { return std::move(out_); }

 private:
  void write(const std::string& file, std::string_view package, const ProtoMessage& message) {
    const std::vector<ProtoField> fields = fieldsOf(package, message);
    std::set<std::string> needs;
    for (const ProtoField& field : fields) {
      if (field.type != kMessage) continue;
      add(field.type_name);
      needs.insert(fileOf(field.type_name));
    }
    ProtoWriter(out_).message(1, [&](ProtoWriter& descriptor) {
      descriptor.text(1, file);
      descriptor.text(2, package);
      for (const std::string& needed : needs) descriptor.element(3, needed);
      descriptor.message(4, [&](ProtoWriter& type) { writeMessage(type, message, fields); });
      descriptor.text(12, "proto3");
    });
  }

  static void writeMessage(ProtoWriter& type, const ProtoMessage& message,
                           const std::vector<ProtoField>& fields) {
    type.text(1, message.name);
    std::uint32_t optionals = 0;
    for (const ProtoField& field : fields) {
      type.message(2, [&](ProtoWriter& out) {
        out.text(1, field.name);
        out.number(3, field.number);
        out.number(4, field.is_repeated ? kRepeated : kSingle);
        out.number(5, field.type);
        out.text(6, field.type_name);
        if (!field.is_optional) return;
        // proto3's `optional` is a oneof of one field; the first index is written though it is 0.
        out.index(9, optionals++);
        out.number(17, 1);
      });
    }
    for (const ProtoEnum& each : enumsOf(message)) {
      type.message(4, [&](ProtoWriter& out) {
        out.text(1, each.name);
        for (const EnumValue& value : each.values) {
          out.message(2, [&](ProtoWriter& of) {
            of.text(1, value.name);
            of.index(2, value.number);
          });
        }
      });
    }
    for (const ProtoField& field : fields) {
      if (!field.is_optional) continue;
      type.message(8, [&](ProtoWriter& out) { out.text(1, "_" + field.name); });
    }
  }

  std::string package_;
  std::span<const ProtoMessage> messages_;
  std::set<std::string> added_;
  Bytes out_;
};

}  // namespace

Bytes fileDescriptorSet(std::string_view package, std::span<const ProtoMessage> messages,
                        std::string_view root) {
  DescriptorSet set(package, messages);
  set.add("." + std::string(package) + "." + std::string(root));
  return set.take();
}

}  // namespace rocinante
