#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "core/base/time.h"
#include "core/net/endpoint.h"

namespace rocinante {

/// Makes and checks the cookies that prove that a subscriber receives at its address
/// (docs/subscriptions.md): 16 bytes of BLAKE2b over address, port and time slot, keyed with 32
/// random bytes of this object, in 32 hexadecimal digits. Remembers no address. One thread.
class CookieMint {
 public:
  static constexpr Nanoseconds kSlot = std::chrono::seconds(30);
  static constexpr std::size_t kTextBytes = 32;
  using Key = std::array<unsigned char, 32>;

  /// Draws a new key from the system.
  CookieMint();
  explicit CookieMint(const Key& key) : key_(key) {}

  std::string cookieFor(const SocketAddress& address, SteadyTime now) const;
  /// True for a cookie of this slot or one of the two before it.
  bool accepts(std::string_view cookie, const SocketAddress& address, SteadyTime now) const;

 private:
  std::string cookieOf(const SocketAddress& address, std::int64_t slot) const;

  Key key_;
};

}  // namespace rocinante
