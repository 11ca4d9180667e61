#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/net/endpoint.h"

namespace rocinante {

/// ::ffff:10.0.0.7, the form in which an IPv6 socket sees an IPv4 sender, becomes 10.0.0.7; other
/// addresses stay as they are.
SocketAddress withoutMapping(const SocketAddress& address);

/// The networks from which datagrams are accepted (`--allow CIDR`). Empty: any network. A plain
/// value.
class AddressFilter {
 public:
  /// "10.0.0.0/8", "fd00::/8", or one address. bad_argument with the reason: a prefix that is too
  /// long, or address bits beyond the prefix, which would suggest another network than the one
  /// meant.
  Status add(std::string_view cidr);

  /// Parses all of them, or returns the first failure.
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
