#include "player/control/control_address.h"

#include <ifaddrs.h>
#include <netinet/in.h>
#include <sys/un.h>

#include <cstring>
#include <string>

#include "core/net/address_filter.h"
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
    return Error{ErrorKind::bad_argument, "a control endpoint cannot be a multicast group",
                 std::string(text)};
  }
  parsed.endpoint = *endpoint;
  return parsed;
}

bool isOwnAddress(const SocketAddress& sender) {
  const SocketAddress address = withoutMapping(sender);
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
