// librocinante_protobuf_messages.so: messages of a type that is known from a FileDescriptorSet
// alone.
#include "core/foreign/protobuf/protobuf_module.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/dynamic_message.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "core/foreign/protobuf/message_cost.h"
#include "core/foreign/protobuf/message_path.h"

namespace pb = google::protobuf;
using rocinante::protobuf::listValues;
using rocinante::protobuf::MessageCost;
using rocinante::protobuf::MessagePath;

struct RocinanteProtobufSchema {
  pb::DescriptorPool pool;
  mutable pb::DynamicMessageFactory factory{&pool};
  const pb::Descriptor* type = nullptr;
};

struct RocinanteProtobufReader {
  explicit RocinanteProtobufReader(const RocinanteProtobufSchema& schema)
      : type(*schema.type),
        cost(schema.factory),
        message(schema.factory.GetPrototype(schema.type)->New()) {}

  const pb::Descriptor& type;
  MessageCost cost;
  std::unique_ptr<pb::Message> message;
  std::vector<MessagePath> paths;
  std::vector<std::string> scratch;  ///< by path
};

namespace {

#define ROCINANTE_EXPORT extern "C" __attribute__((visibility("default")))

constexpr std::size_t kMaxMessageBytes = std::size_t{1} << 20U;
// libprotobuf goes through a chain of types by calling itself.
constexpr int kMaxTypes = 4096;
constexpr int kMaxFields = 65'536;
constexpr int kDeepestType = 64;

/// Names in a set may hold NUL bytes.
void answer(char* error, std::size_t bytes, std::string text) {
  std::replace(text.begin(), text.end(), '\0', '?');
  std::snprintf(error, bytes, "%s", text.c_str());
}

/// Counts what a set declares; false beyond the limits.
struct TypeCount {
  int types = 0;
  int fields = 0;

  bool add(const pb::DescriptorProto& type, int depth) {
    types += 1 + type.enum_type_size();
    fields += type.field_size() + type.extension_size() + type.oneof_decl_size();
    for (const auto& each : type.enum_type()) fields += each.value_size();
    if (types > kMaxTypes || fields > kMaxFields || depth > kDeepestType) return false;
    for (const auto& each : type.nested_type()) {
      if (!add(each, depth + 1)) return false;
    }
    return true;
  }
};

/// Keeps the first fault that a set has.
class FirstFault final : public pb::DescriptorPool::ErrorCollector {
 public:
  void AddError(const std::string& file, const std::string& element, const pb::Message*,
                ErrorLocation, const std::string& text) override {
    if (text_.empty()) text_ = file + ": " + element + ": " + text;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

std::string typesOf(const pb::FileDescriptorSet& set) {
  std::string names;
  int count = 0;
  for (const auto& file : set.file()) {
    for (const auto& type : file.message_type()) {
      if (++count > 12) return names + ", ...";
      names += (names.empty() ? "" : ", ") + (file.package().empty() ? "" : file.package() + ".") +
               type.name();
    }
  }
  return names.empty() ? "none" : names;
}

/// One sentence when the set is not sound.
std::string load(const std::string& bytes, const std::string& message,
                 RocinanteProtobufSchema& schema) {
  pb::FileDescriptorSet set;
  if (!set.ParseFromString(bytes) || set.file_size() == 0) {
    return "it is not a FileDescriptorSet, which `protoc --include_imports -o FILE` writes";
  }
  TypeCount count;
  for (const auto& file : set.file()) {
    for (const auto& type : file.message_type()) {
      if (!count.add(type, 0)) return "it declares more than 4,096 types or 65,536 fields";
    }
    count.fields += file.extension_size() + file.dependency_size();
    count.types += file.enum_type_size() + file.service_size() + 1;
    for (const auto& type : file.enum_type()) count.fields += type.value_size();
    if (count.types > kMaxTypes || count.fields > kMaxFields) {
      return "it declares more than 4,096 types or 65,536 fields";
    }
  }
  for (const auto& file : set.file()) {
    FirstFault fault;
    if (schema.pool.BuildFileCollectingErrors(file, &fault) == nullptr) {
      return fault.text().empty() ? "one of its files is not sound" : fault.text();
    }
  }
  schema.type = schema.pool.FindMessageTypeByName(message);
  if (schema.type == nullptr) {
    return "it has no message `" + message + "`; its messages: " + typesOf(set);
  }
  if (schema.type->options().map_entry()) return "`" + message + "` is part of a map";
  if (schema.factory.GetPrototype(schema.type) == nullptr) return "its messages cannot be made";
  return {};
}

/// Null, or why the bytes are not a message.
const char* parse(RocinanteProtobufReader& reader, const void* bytes, std::size_t size) {
  if (size > kMaxMessageBytes) return "it has more than 1 MiB";
  switch (reader.cost.of(reader.type, {static_cast<const char*>(bytes), size})) {
    case MessageCost::Answer::fits:
      break;
    case MessageCost::Answer::malformed:
      return "it is not a protobuf message";
    case MessageCost::Answer::too_deep:
      return "its messages are nested deeper than 64";
    case MessageCost::Answer::too_large:
      return "it would need more than 64 MiB of memory";
    case MessageCost::Answer::unknown:
      return "it has no field of the message";
  }
  if (!reader.message->ParsePartialFromArray(bytes, static_cast<int>(size))) {
    return "it is not a protobuf message";
  }
  if (!reader.message->IsInitialized()) return "a field that the message requires is missing";
  return nullptr;
}

}  // namespace

ROCINANTE_EXPORT int rocinante_protobuf_abi() { return ROCINANTE_PROTOBUF_ABI; }

ROCINANTE_EXPORT RocinanteProtobufSchema* rocinante_protobuf_open(const void* set,
                                                                  std::size_t bytes,
                                                                  const char* message, char* error,
                                                                  std::size_t error_bytes) try {
#if GOOGLE_PROTOBUF_VERSION < 4022000
  pb::SetLogHandler(nullptr);
#endif
  auto schema = std::make_unique<RocinanteProtobufSchema>();
  const std::string fault =
      load(std::string(static_cast<const char*>(set), bytes), message, *schema);
  if (fault.empty()) return schema.release();
  answer(error, error_bytes, fault);
  return nullptr;
} catch (const std::exception& fault) {
  answer(error, error_bytes, std::string("libprotobuf: ") + fault.what());
  return nullptr;
}

ROCINANTE_EXPORT void rocinante_protobuf_close(RocinanteProtobufSchema* schema) { delete schema; }

ROCINANTE_EXPORT std::int32_t rocinante_protobuf_find(const RocinanteProtobufSchema* schema,
                                                      const char* path, char* error,
                                                      std::size_t error_bytes) try {
  MessagePath found;
  std::string fault;
  if (findPath(*schema->type, path, found, fault)) return 1;
  answer(error, error_bytes, fault);
  return 0;
} catch (const std::exception& fault) {
  answer(error, error_bytes, std::string("libprotobuf: ") + fault.what());
  return 0;
}

ROCINANTE_EXPORT RocinanteProtobufReader* rocinante_protobuf_read_of(
    const RocinanteProtobufSchema* schema, const char* const* paths, std::size_t count) try {
  auto reader = std::make_unique<RocinanteProtobufReader>(*schema);
  std::string fault;
  for (std::size_t i = 0; i < count; ++i) {
    if (!findPath(*schema->type, paths[i], reader->paths.emplace_back(), fault)) return nullptr;
  }
  reader->scratch.resize(count);
  return reader.release();
} catch (const std::exception&) {
  return nullptr;
}

ROCINANTE_EXPORT void rocinante_protobuf_end(RocinanteProtobufReader* reader) { delete reader; }

ROCINANTE_EXPORT const char* rocinante_protobuf_read(RocinanteProtobufReader* reader,
                                                     const void* message, std::size_t bytes,
                                                     RocinanteProtobufValue* values) try {
  if (const char* const reason = parse(*reader, message, bytes)) return reason;
  for (std::size_t i = 0; i < reader->paths.size(); ++i) {
    values[i] = valueAt(*reader->message, reader->paths[i], reader->scratch[i]);
  }
  return nullptr;
} catch (const std::exception&) {
  return "libprotobuf cannot read it";
}

ROCINANTE_EXPORT void rocinante_protobuf_list(RocinanteProtobufReader* reader, const void* message,
                                              std::size_t bytes, RocinanteProtobufFound found,
                                              void* to) try {
  if (parse(*reader, message, bytes) == nullptr) listValues(*reader->message, found, to);
} catch (const std::exception&) {
  return;
}
