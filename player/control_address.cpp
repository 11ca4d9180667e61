#include "player/control_address.h"

#include <ifaddrs.h>
#include <netinet/in.h>
#include <sys/un.h>

#include <charconv>
#include <cstring>
#include <string>

#include "core/net/system_socket.h"

namespace rocinante {

Result<ControlAddress> ControlAddress::parse(std::string_view text) {
  constexpr std::string_view kUnix = "unix:";
  ControlAddress parsed;
  if (text.starts_with(kUnix)) {
    parsed.path = std::string(text.substr(kUnix.size()));
    if (parsed.path.empty() || parsed.path.native().size() >= sizeof(sockaddr_un::sun_path)) {
      return Error{ErrorKind::bad_argument,
                   "a control endpoint is udp://HOST:PORT or unix:PATH, the path of 1 to 107 bytes",
                   std::string(text)};
    }
    return parsed;
  }
  const Result<Endpoint> endpoint = Endpoint::parse(text);
  if (!endpoint) return endpoint.error();
  if (endpoint->isMulticast()) {
    return Error{ErrorKind::bad_argument, "a player cannot be controlled by a multicast group",
                 std::string(text)};
  }
  parsed.endpoint = *endpoint;
  return parsed;
}

Result<AddressBlock> AddressBlock::parse(std::string_view text) {
  const std::size_t slash = text.find('/');
  const Result<SocketAddress> address = SocketAddress::parse(text.substr(0, slash), 0);
  if (!address) return address.error();
  AddressBlock block{*address, address->is_ipv6 ? 128 : 32};
  if (slash == text.npos) return block;
  const std::string_view digits = text.substr(slash + 1);
  int bits = -1;
  const auto [stop, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), bits);
  if (fault != std::errc() || stop != digits.data() + digits.size() || bits < 0 ||
      bits > block.bits) {
    return Error{ErrorKind::bad_argument, "a block of addresses is ADDRESS/BITS, as in 10.0.0.0/8",
                 std::string(text)};
  }
  block.bits = bits;
  return block;
}

bool AddressBlock::holds(const SocketAddress& other) const {
  if (other.is_ipv6 != address.is_ipv6) return false;
  for (int bit = 0; bit < bits; ++bit) {
    const auto byte = static_cast<std::size_t>(bit / 8);
    const int mask = 0x80 >> (bit % 8);
    if (((address.address[byte] ^ other.address[byte]) & mask) != 0) return false;
  }
  return true;
}

bool isOwnAddress(const SocketAddress& address) {
  static const AddressBlock kLoopback4 = *AddressBlock::parse("127.0.0.0/8");
  static const AddressBlock kLoopback6 = *AddressBlock::parse("::1");
  if (kLoopback4.holds(address) || kLoopback6.holds(address)) return true;
  ifaddrs* all = nullptr;
  if (::getifaddrs(&all) != 0) return false;
  bool found = false;
  for (const ifaddrs* each = all; each != nullptr && !found; each = each->ifa_next) {
    if (each->ifa_addr == nullptr) continue;
    const int family = each->ifa_addr->sa_family;
    if (family != AF_INET && family != AF_INET6) continue;
    sockaddr_storage system{};
    std::memcpy(&system, each->ifa_addr,
                family == AF_INET ? sizeof(sockaddr_in) : sizeof(sockaddr_in6));
    const SocketAddress own = fromSystem(system);
    found = own.is_ipv6 == address.is_ipv6 && own.address == address.address;
  }
  ::freeifaddrs(all);
  return found;
}

}  // namespace rocinante
