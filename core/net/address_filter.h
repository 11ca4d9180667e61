#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/net/endpoint.h"

namespace rocinante {

/// ::ffff:10.0.0.7, as which a socket of IPv6 sees a sender of IPv4, as 10.0.0.7; others as they
/// are.
SocketAddress withoutMapping(const SocketAddress& address);

/// The networks from which datagrams are taken (`--allow CIDR`). Empty: from everywhere. A plain
/// value.
class AddressFilter {
 public:
  /// "10.0.0.0/8", "fd00::/8", or one address. bad_argument with the reason: a prefix that is too
  /// long, or bits beyond it, which would say something else than it seems to.
  Status add(std::string_view cidr);

  /// All of them, or the first failure.
  static Result<AddressFilter> of(const std::vector<std::string>& networks);

  bool empty() const { return networks_.empty(); }
  bool allows(const SocketAddress& sender) const;

 private:
  struct Words {
    std::uint64_t high = 0, low = 0;
  };
  struct Network {
    bool is_ipv6 = false;
    Words bits, mask;
  };
  static Words wordsOf(const SocketAddress& address);

  std::vector<Network> networks_;
};

}  // namespace rocinante
