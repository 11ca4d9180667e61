#include "player/source/source_start.h"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <span>

#include "core/base/hash.h"
#include "core/signing/signed_datagram.h"

namespace rocinante {

WallTime wallNow() { return std::chrono::system_clock::now(); }

std::string runOf(const SourceOptions& options) {
  if (!options.run.empty()) return options.run;
  std::array<unsigned char, 5> random{};
  if (::getrandom(random.data(), random.size(), 0) != static_cast<ssize_t>(random.size())) {
    const auto now = static_cast<std::uint64_t>(wallNow().time_since_epoch().count());
    for (std::size_t i = 0; i < random.size(); ++i) {
      random[i] = static_cast<unsigned char>(now >> (8 * i));
    }
  }
  return hexOf(std::as_bytes(std::span(random)));
}

std::size_t unsignedBytes(const SourceOptions& options) {
  const std::size_t room = options.key.empty() ? 0 : kSignatureBytes;
  return options.mtu_bytes - std::min(options.mtu_bytes, room);
}

}  // namespace rocinante
