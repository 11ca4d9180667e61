#include "core/mcap/lz4_frame.h"

namespace rocinante::mcap {

bool canExpandLz4() { return false; }

Result<std::size_t> expandLz4(ByteView, std::byte*, std::size_t) {
  return Error{ErrorKind::unsupported,
               "the chunk is compressed with \"lz4\", which this build cannot read",
               {}};
}

std::size_t expandCutLz4(ByteView, std::byte*, std::size_t) { return 0; }

}  // namespace rocinante::mcap
