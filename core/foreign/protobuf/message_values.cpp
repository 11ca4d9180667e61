#include "core/foreign/protobuf/message_values.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/unknown_field_set.h>

#include <charconv>
#include <string>

#include "core/foreign/protobuf/message_path.h"

namespace rocinante::protobuf {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;
using google::protobuf::UnknownField;

class ValueList {
 public:
  ValueList(RocinanteProtobufFound found, void* to) : found_(found), to_(to) {}

  /// False: enough. As deep as libprotobuf parses.
  bool add(const Message& message, const std::string& before) {
    std::vector<const FieldDescriptor*> fields;
    const Reflection& has = *message.GetReflection();
    has.ListFields(message, &fields);
    for (const FieldDescriptor* const field : fields) {
      if (field->is_map()) continue;
      const std::string path = before + std::string(field->name());
      if (!field->is_repeated()) {
        if (!addOne(message, {field, -1}, path)) return false;
        continue;
      }
      for (int i = 0; i < has.FieldSize(message, field); ++i) {
        if (!addOne(message, {field, i}, path + "[" + std::to_string(i) + "]")) return false;
      }
    }
    const auto& unknown = has.GetUnknownFields(message);
    for (int i = 0; i < unknown.field_count(); ++i) {
      const UnknownField& field = unknown.field(i);
      if (!say(before + "#" + std::to_string(field.number()), wordsOf(field))) return false;
    }
    return true;
  }

 private:
  bool addOne(const Message& message, const MessagePath::Step& step, const std::string& path) {
    const Reflection& has = *message.GetReflection();
    if (step.field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
      return add(step.index < 0 ? has.GetMessage(message, step.field)
                                : has.GetRepeatedMessage(message, step.field, step.index),
                 path + ".");
    }
    const RocinanteProtobufValue value = valueOf(message, step, scratch_);
    if (value.kind == 2) return say(path, {value.text, value.text_bytes});
    char digits[40];
    const auto end = std::to_chars(digits, digits + sizeof digits, value.number).ptr;
    return say(path, {digits, static_cast<std::size_t>(end - digits)});
  }

  static std::string wordsOf(const UnknownField& field) {
    switch (field.type()) {
      case UnknownField::TYPE_VARINT:
        return std::to_string(field.varint());
      case UnknownField::TYPE_FIXED32:
        return std::to_string(field.fixed32()) + " (4 bytes)";
      case UnknownField::TYPE_FIXED64:
        return std::to_string(field.fixed64()) + " (8 bytes)";
      case UnknownField::TYPE_LENGTH_DELIMITED:
        return std::to_string(field.length_delimited().size()) + " bytes";
      case UnknownField::TYPE_GROUP:
        return "a group";
    }
    return {};
  }

  bool say(const std::string& path, std::string_view value) {
    return found_(to_, path.data(), path.size(), value.data(), value.size()) != 0;
  }

  RocinanteProtobufFound found_;
  void* to_;
  std::string scratch_;
};

}  // namespace

void listValues(const Message& message, RocinanteProtobufFound found, void* to) {
  ValueList(found, to).add(message, "");
}

}  // namespace rocinante::protobuf
