#include "core/subscription/subscription_cookie.h"

#include <sodium/crypto_generichash.h>
#include <sodium/randombytes.h>
#include <sodium/utils.h>

#include <algorithm>
#include <cstring>

#include "core/base/hash.h"

namespace rocinante {
namespace {

std::int64_t slotOf(SteadyTime now) { return now.time_since_epoch() / CookieMint::kSlot; }

}  // namespace

CookieMint::CookieMint() : key_{} { randombytes_buf(key_.data(), key_.size()); }

std::string CookieMint::cookieOf(const SocketAddress& address, std::int64_t slot) const {
  // family, address, scope, port, slot
  std::array<unsigned char, 1 + 16 + 4 + 2 + 8> input{};
  input[0] = address.is_ipv6 ? 6 : 4;
  std::copy(address.address.begin(), address.address.end(), input.begin() + 1);
  std::memcpy(&input[17], &address.scope_id, 4);
  std::memcpy(&input[21], &address.port, 2);
  std::memcpy(&input[23], &slot, 8);
  std::array<unsigned char, kTextBytes / 2> hash{};
  crypto_generichash(hash.data(), hash.size(), input.data(), input.size(), key_.data(),
                     key_.size());
  return hexOf(std::as_bytes(std::span(hash)));
}

std::string CookieMint::cookieFor(const SocketAddress& address, SteadyTime now) const {
  return cookieOf(address, slotOf(now));
}

bool CookieMint::accepts(std::string_view cookie, const SocketAddress& address,
                         SteadyTime now) const {
  if (cookie.size() != kTextBytes) return false;
  const std::int64_t slot = slotOf(now);
  bool accepted = false;
  for (std::int64_t before = 0; before <= 2 && !accepted; ++before) {
    accepted =
        sodium_memcmp(cookieOf(address, slot - before).data(), cookie.data(), kTextBytes) == 0;
  }
  return accepted;
}

}  // namespace rocinante
