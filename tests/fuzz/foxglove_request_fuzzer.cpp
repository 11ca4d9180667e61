// What a client of foxglove.websocket.v1 sends, a message a line; a binary one begins with a NUL.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "viewer/serve/foxglove_client.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rocinante;
  static const Cell cell;
  FoxgloveDesk desk(cell, "fuzz");
  const MessageSchema schema{"foxglove.Log", "protobuf", {}, "protobuf"};
  (void)desk.write("/a", schema, LogTime{}, {}, {});
  (void)desk.write("/b", schema, LogTime{}, {}, {});
  FoxgloveClient client(desk);
  std::string_view left(reinterpret_cast<const char*>(data), size);
  while (!left.empty()) {
    const std::size_t end = left.find('\n');
    const std::string_view message = left.substr(0, end);
    left.remove_prefix(end == std::string_view::npos ? left.size() : end + 1);
    client.receive(message, message.starts_with('\0'));
    if (message.size() % 3 == 0) (void)client.next();
  }
  while (client.next()) {
  }
  return 0;
}
