// What a page gets through its socket, in two messages cut at a byte of the input.
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "viewer/web/web_live.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rocinante;
  if (size == 0) return 0;
  const ByteView bytes(reinterpret_cast<const std::byte*>(data + 1), size - 1);
  const std::size_t cut = std::min<std::size_t>(data[0], bytes.size());
  WebLive live;
  (void)live.take(bytes.first(cut));
  (void)live.take(bytes.subspan(cut));
  return 0;
}
