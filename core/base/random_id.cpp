#include "core/base/random_id.h"

#include <sys/random.h>

#include <cerrno>
#include <cstdlib>
#include <span>

#include "core/base/bytes.h"
#include "core/base/hash.h"

namespace rocinante {
namespace {

void fillRandom(std::span<std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t got = ::getrandom(bytes.data(), bytes.size(), 0);
    // Linux has had it since 3.17: without it nothing that must differ would.
    if (got < 0 && errno != EINTR) std::abort();
    if (got > 0) bytes = bytes.subspan(static_cast<std::size_t>(got));
  }
}

}  // namespace

std::string randomId(std::size_t bytes) {
  Bytes random(bytes);
  fillRandom(random);
  return hexOf(random);
}

std::uint64_t randomNumber() {
  std::uint64_t number = 0;
  fillRandom(std::as_writable_bytes(std::span(&number, 1)));
  return number;
}

}  // namespace rocinante
