#include "core/net/local_address.h"

#include <ifaddrs.h>
#include <netinet/in.h>

#include <cstring>

#include "core/net/address_filter.h"
#include "core/net/system_socket.h"

namespace rocinante {

// Not by bind(): with net.ipv4.ip_nonlocal_bind the kernel binds to anybody's address.
bool isOwnAddress(const SocketAddress& sought) {
  const SocketAddress address = withoutMapping(sought);
  static const AddressFilter kLoopback = AddressFilter::of({"127.0.0.0/8", "::1"}).value();
  if (kLoopback.allows(address)) return true;
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
