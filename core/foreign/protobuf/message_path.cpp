#include "core/foreign/protobuf/message_path.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/unknown_field_set.h>

#include <charconv>
#include <string>

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

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

constexpr std::size_t kMaxSteps = 64;
constexpr std::size_t kMaxNames = 12;

std::string quoted(std::string_view text) { return "`" + std::string(text) + "`"; }

std::string fieldsOf(const Descriptor& type) {
  std::string names;
  for (int i = 0; i < type.field_count() && i < static_cast<int>(kMaxNames); ++i) {
    names += (i == 0 ? "" : ", ") + std::string(type.field(i)->name());
  }
  if (type.field_count() > static_cast<int>(kMaxNames)) names += ", ...";
  return names.empty() ? "none" : names;
}

/// "b[2]" in its name and index; -1 without one, -2 for what is no index.
int takeIndex(std::string_view& step) {
  const std::size_t open = step.find('[');
  if (open == step.npos) return -1;
  const std::string_view digits = step.substr(open + 1);
  step = step.substr(0, open);
  int index = -2;
  const char* const end = digits.data() + digits.size();
  const auto [stop, fault] = std::from_chars(digits.data(), end, index);
  return fault == std::errc() && stop + 1 == end && *stop == ']' && index >= 0 ? index : -2;
}

}  // namespace

void listValues(const Message& message, RocinanteProtobufFound found, void* to) {
  ValueList(found, to).add(message, "");
}

bool findPath(const Descriptor& type, std::string_view path, MessagePath& found,
              std::string& error) {
  const Descriptor* at = &type;
  std::string_view rest = path;
  while (found.steps.size() < kMaxSteps) {
    const std::size_t dot = rest.find('.');
    std::string_view name = rest.substr(0, dot);
    const int index = takeIndex(name);
    const FieldDescriptor* const field = at->FindFieldByName(std::string(name));
    if (field == nullptr) {
      error = std::string(at->full_name()) + " has no field " + quoted(name) +
              "; its fields: " + fieldsOf(*at);
      return false;
    }
    if (field->is_map()) {
      error = quoted(name) + " is a map, whose values have no order";
      return false;
    }
    if (index == -2 || (index >= 0) != field->is_repeated()) {
      error = quoted(name) +
              (field->is_repeated() ? " is repeated: give the index, as in "
                                    : " has one value, without an index: ") +
              quoted(std::string(name) + (field->is_repeated() ? "[0]" : ""));
      return false;
    }
    found.steps.push_back({field, index});
    const bool is_message = field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
    if (dot == rest.npos) {
      if (!is_message) return true;
      error = quoted(name) +
              " is a message: go on to one of its fields: " + fieldsOf(*field->message_type());
      return false;
    }
    if (!is_message) {
      error = quoted(name) + " is a value, which has no fields";
      return false;
    }
    at = field->message_type();
    rest.remove_prefix(dot + 1);
  }
  error = "the path has more than 64 steps";
  return false;
}

RocinanteProtobufValue valueOf(const Message& message, const MessagePath::Step& step,
                               std::string& scratch) {
  const FieldDescriptor* const field = step.field;
  const Reflection& has = *message.GetReflection();
  const int at = step.index;
  if (at >= 0 ? at >= has.FieldSize(message, field)
              : field->has_presence() && !has.HasField(message, field)) {
    return {};
  }
  const auto number = [](auto value) {
    return RocinanteProtobufValue{1, static_cast<double>(value), nullptr, 0};
  };
  switch (field->cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
      return number(at < 0 ? has.GetInt32(message, field)
                           : has.GetRepeatedInt32(message, field, at));
    case FieldDescriptor::CPPTYPE_INT64:
      return number(at < 0 ? has.GetInt64(message, field)
                           : has.GetRepeatedInt64(message, field, at));
    case FieldDescriptor::CPPTYPE_UINT32:
      return number(at < 0 ? has.GetUInt32(message, field)
                           : has.GetRepeatedUInt32(message, field, at));
    case FieldDescriptor::CPPTYPE_UINT64:
      return number(at < 0 ? has.GetUInt64(message, field)
                           : has.GetRepeatedUInt64(message, field, at));
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return number(at < 0 ? has.GetDouble(message, field)
                           : has.GetRepeatedDouble(message, field, at));
    case FieldDescriptor::CPPTYPE_FLOAT:
      return number(at < 0 ? has.GetFloat(message, field)
                           : has.GetRepeatedFloat(message, field, at));
    case FieldDescriptor::CPPTYPE_BOOL:
      return number(at < 0 ? has.GetBool(message, field) : has.GetRepeatedBool(message, field, at));
    case FieldDescriptor::CPPTYPE_ENUM:
      return number(at < 0 ? has.GetEnumValue(message, field)
                           : has.GetRepeatedEnumValue(message, field, at));
    case FieldDescriptor::CPPTYPE_STRING: {
      const std::string& text = at < 0
                                    ? has.GetStringReference(message, field, &scratch)
                                    : has.GetRepeatedStringReference(message, field, at, &scratch);
      return {2, 0, text.data(), text.size()};
    }
    case FieldDescriptor::CPPTYPE_MESSAGE:
      break;
  }
  return {};
}

RocinanteProtobufValue valueAt(const Message& message, const MessagePath& path,
                               std::string& scratch) {
  const Message* at = &message;
  for (std::size_t i = 0; i + 1 < path.steps.size(); ++i) {
    const auto [field, index] = path.steps[i];
    const Reflection& has = *at->GetReflection();
    if (index >= 0) {
      if (index >= has.FieldSize(*at, field)) return {};
      at = &has.GetRepeatedMessage(*at, field, index);
    } else {
      if (!has.HasField(*at, field)) return {};
      at = &has.GetMessage(*at, field);
    }
  }
  return valueOf(*at, path.steps.back(), scratch);
}

}  // namespace rocinante::protobuf
