#include "core/mcap/lz4_frame.h"

#include <lz4frame.h>

#include <memory>
#include <string>

namespace rocinante::mcap {
namespace {

struct FreeContext {
  void operator()(LZ4F_dctx* context) const { LZ4F_freeDecompressionContext(context); }
};

struct Expanded {
  std::size_t bytes = 0;
  const char* fault = nullptr;  ///< null: whole frames
};

Expanded expandFrames(ByteView frames, std::byte* out, std::size_t room) {
  LZ4F_dctx* made = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION)) != 0U) {
    return {0, "out of memory"};
  }
  const std::unique_ptr<LZ4F_dctx, FreeContext> context(made);
  Expanded result;
  std::size_t taken = 0;
  std::size_t wanted = 1;
  while (taken < frames.size()) {
    std::size_t in_bytes = frames.size() - taken;
    std::size_t out_bytes = room - result.bytes;
    wanted = LZ4F_decompress(made, out + result.bytes, &out_bytes, frames.data() + taken, &in_bytes,
                             nullptr);
    if (LZ4F_isError(wanted) != 0U) return {result.bytes, LZ4F_getErrorName(wanted)};
    result.bytes += out_bytes;
    taken += in_bytes;
    if (in_bytes == 0 && out_bytes == 0)
      return {result.bytes, "it holds more than its header says"};
  }
  if (wanted != 0) result.fault = "it ends inside a frame";
  return result;
}

}  // namespace

bool canExpandLz4() { return true; }

Result<std::size_t> expandLz4(ByteView frames, std::byte* out, std::size_t room) {
  const Expanded expanded = expandFrames(frames, out, room);
  if (expanded.fault != nullptr) {
    return Error{
        ErrorKind::damaged, std::string("the chunk does not decompress: ") + expanded.fault, {}};
  }
  return expanded.bytes;
}

std::size_t expandCutLz4(ByteView frames, std::byte* out, std::size_t room) {
  return expandFrames(frames, out, room).bytes;
}

}  // namespace rocinante::mcap
