// What the protobuf module makes of any descriptor set and any message: the bytes are a length of
// two bytes, a descriptor set of that length, the message's name with a NUL, and a message. The
// module is part of the program here; the library below it is the system's, without sanitizers.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "core/foreign/protobuf/protobuf_module.h"

extern "C" {
RocinanteProtobufSchema* rocinante_protobuf_open(const void*, size_t, const char*, char*, size_t);
void rocinante_protobuf_close(RocinanteProtobufSchema*);
int32_t rocinante_protobuf_find(const RocinanteProtobufSchema*, const char*, char*, size_t);
RocinanteProtobufReader* rocinante_protobuf_read_of(const RocinanteProtobufSchema*,
                                                    const char* const*, size_t);
void rocinante_protobuf_end(RocinanteProtobufReader*);
const char* rocinante_protobuf_read(RocinanteProtobufReader*, const void*, size_t,
                                    RocinanteProtobufValue*);
void rocinante_protobuf_list(RocinanteProtobufReader*, const void*, size_t, RocinanteProtobufFound,
                             void*);
}

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

std::int32_t keepPath(void* to, const char* path, std::size_t bytes, const char*, std::size_t) {
  auto& paths = *static_cast<std::vector<std::string>*>(to);
  paths.emplace_back(path, bytes);
  return paths.size() < 50 ? 1 : 0;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  std::string_view rest(reinterpret_cast<const char*>(data) + 2, size - 2);
  const std::string_view set = rest.substr(0, data[0] * 256U + data[1]);
  rest.remove_prefix(set.size());
  const std::string name(rest.substr(0, rest.find('\0')));
  rest.remove_prefix(std::min(name.size() + 1, rest.size()));
  char error[256] = "";
  RocinanteProtobufSchema* const schema =
      rocinante_protobuf_open(set.data(), set.size(), name.c_str(), error, sizeof error);
  require((schema == nullptr) == (error[0] != '\0'));
  if (schema == nullptr) return 0;
  // First every value that the message has, then these by their paths.
  std::vector<std::string> named;
  RocinanteProtobufReader* reader = rocinante_protobuf_read_of(schema, nullptr, 0);
  require(reader != nullptr);
  rocinante_protobuf_list(reader, rest.data(), rest.size(), keepPath, &named);
  rocinante_protobuf_end(reader);
  std::vector<const char*> paths;
  for (const std::string& each : named) {
    const bool is_known = each.find('#') == each.npos;
    const bool found = rocinante_protobuf_find(schema, each.c_str(), error, sizeof error) != 0;
    require(found == is_known);
    if (found) paths.push_back(each.c_str());
  }
  reader = rocinante_protobuf_read_of(schema, paths.data(), paths.size());
  require(reader != nullptr);
  std::vector<RocinanteProtobufValue> values(paths.size());
  const bool sound =
      rocinante_protobuf_read(reader, rest.data(), rest.size(), values.data()) == nullptr;
  require(sound || paths.empty());
  for (const RocinanteProtobufValue& value : values) {
    require(value.kind == 1 || value.kind == 2);
    if (value.kind == 2) require(std::string(value.text, value.text_bytes).size() < size);
  }
  rocinante_protobuf_end(reader);
  rocinante_protobuf_close(schema);
  return 0;
}
