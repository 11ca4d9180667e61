#include "player/source/source_start.h"

#include <algorithm>

#include "core/base/random_id.h"
#include "core/signing/signed_datagram.h"

namespace rocinante {

WallTime wallNow() { return std::chrono::system_clock::now(); }

std::string runOf(const SourceOptions& options) {
  if (!options.run.empty()) return options.run;
  return randomId(5);
}

std::size_t unsignedBytes(const SourceOptions& options) {
  const std::size_t room = options.key.empty() ? 0 : kSignatureBytes;
  return options.mtu_bytes - std::min(options.mtu_bytes, room);
}

}  // namespace rocinante
