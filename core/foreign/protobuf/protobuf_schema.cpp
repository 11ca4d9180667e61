#include "core/foreign/protobuf/protobuf_schema.h"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "core/base/loaded_module.h"

namespace rocinante::protobuf {
namespace {

constexpr const char* kFile = "librocinante_protobuf_messages.so";

/// The functions of the loaded module, or the reason why it is not loaded.
struct ProtobufModule {
  RocinanteProtobufOpen open = nullptr;
  RocinanteProtobufClose close = nullptr;
  RocinanteProtobufFind find = nullptr;
  RocinanteProtobufReadOf read_of = nullptr;
  RocinanteProtobufEnd end = nullptr;
  RocinanteProtobufRead read = nullptr;
  RocinanteProtobufList list = nullptr;
  std::string reason;

  ProtobufModule() {
    const Result<void*> loaded = loadModule(kFile);
    if (!loaded.ok()) {
      reason = loaded.error().what;
      return;
    }
    const auto get = [&](auto& function, const char* name) {
      function =
          reinterpret_cast<std::remove_reference_t<decltype(function)>>(functionOf(*loaded, name));
      return function != nullptr;
    };
    RocinanteProtobufAbi abi = nullptr;
    if (!get(abi, "rocinante_protobuf_abi") || abi() != ROCINANTE_PROTOBUF_ABI ||
        !get(open, "rocinante_protobuf_open") || !get(close, "rocinante_protobuf_close") ||
        !get(find, "rocinante_protobuf_find") || !get(read_of, "rocinante_protobuf_read_of") ||
        !get(end, "rocinante_protobuf_end") || !get(read, "rocinante_protobuf_read") ||
        !get(list, "rocinante_protobuf_list")) {
      reason = std::string(kFile) + " has a different version";
    }
  }
};

const ProtobufModule& protobufModule() {
  static const ProtobufModule module;
  return module;
}

struct ValueSearch {
  const std::vector<std::string>& known;
  std::size_t most;
  std::vector<NamedValue> found{};
};

std::int32_t keepValue(void* to, const char* path, std::size_t path_bytes, const char* value,
                       std::size_t value_bytes) {
  auto& search = *static_cast<ValueSearch*>(to);
  const std::string_view name(path, path_bytes);
  if (search.found.size() >= search.most) return 0;
  if (std::ranges::find(search.known, name) == search.known.end()) {
    search.found.push_back({std::string(name), std::string(value, value_bytes)});
  }
  return search.found.size() < search.most ? 1 : 0;
}

}  // namespace

Result<std::shared_ptr<const Schema>> Schema::open(std::string_view descriptor_set,
                                                   const std::string& message) {
  const ProtobufModule& module = protobufModule();
  if (!module.reason.empty()) {
    return Error{
        ErrorKind::refused,
        "protobuf is not read without its module (package rocinante-protobuf); " + module.reason,
        {}};
  }
  char error[1024] = "";
  RocinanteProtobufSchema* const schema = module.open(descriptor_set.data(), descriptor_set.size(),
                                                      message.c_str(), error, sizeof error);
  if (schema == nullptr) return Error{ErrorKind::bad_argument, error, {}};
  return std::shared_ptr<const Schema>(new Schema(schema));
}

Schema::~Schema() { protobufModule().close(schema_); }

Status Schema::find(const std::string& path) const {
  char error[1024] = "";
  if (protobufModule().find(schema_, path.c_str(), error, sizeof error) != 0) return {};
  return Error{ErrorKind::bad_argument, error, {}};
}

Reader::Reader(std::shared_ptr<const Schema> schema, const std::vector<std::string>& paths)
    : schema_(std::move(schema)) {
  std::vector<const char*> texts;
  for (const std::string& path : paths) texts.push_back(path.c_str());
  reader_ = protobufModule().read_of(schema_->schema_, texts.data(), texts.size());
  values_.resize(paths.size());
}

Reader::~Reader() { protobufModule().end(reader_); }

std::string_view Reader::read(ByteView message) {
  if (reader_ == nullptr) return "libprotobuf cannot read it";
  const char* const reason =
      protobufModule().read(reader_, message.data(), message.size(), values_.data());
  return reason == nullptr ? std::string_view() : std::string_view(reason);
}

std::vector<NamedValue> Reader::others(ByteView message, const std::vector<std::string>& known,
                                       std::size_t most) {
  ValueSearch search{known, most};
  if (reader_ != nullptr && most > 0) {
    protobufModule().list(reader_, message.data(), message.size(), keepValue, &search);
  }
  return std::move(search.found);
}

}  // namespace rocinante::protobuf
