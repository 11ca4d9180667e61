#include "core/net/interfaces.h"

#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

#include <cstring>
#include <memory>
#include <set>
#include <thread>

#include "core/base/duration_text.h"
#include "core/net/address_filter.h"
#include "core/net/system_socket.h"

namespace rocinante {
namespace {

constexpr Nanoseconds kLook = std::chrono::milliseconds(20);

/// The missing ones, "eth7, eth8"; empty when all exist.
std::string missingInterfaces(std::span<const Endpoint> endpoints) {
  std::set<std::string> missing;
  for (const Endpoint& endpoint : endpoints) {
    const std::string& name = endpoint.interface;
    // "any" is libpcap's word for all interfaces.
    if (name.empty() || (endpoint.isPcap() && name == "any")) continue;
    if (::if_nametoindex(name.c_str()) == 0) missing.insert(name);
  }
  std::string names;
  for (const std::string& name : missing) names += (names.empty() ? "" : ", ") + name;
  return names;
}

}  // namespace

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

Status waitForInterfaces(std::span<const Endpoint> endpoints, Nanoseconds longest,
                         const std::function<void(const std::string&)>& notify,
                         const std::function<bool()>& stop) {
  const auto give_up = std::chrono::steady_clock::now() + longest;
  for (bool is_reported = false;; is_reported = true) {
    const std::string missing = missingInterfaces(endpoints);
    if (missing.empty()) return {};
    if (!is_reported) notify("waiting for the network interface " + missing);
    if (stop()) {
      return Error{ErrorKind::refused, "interrupted while waiting for a network interface",
                   missing};
    }
    if (std::chrono::steady_clock::now() >= give_up) {
      return Error{ErrorKind::refused,
                   "the network interface did not appear within " + secondsText(longest) +
                       " s; there are " + interfaceNames(),
                   missing};
    }
    std::this_thread::sleep_for(kLook);
  }
}

std::string interfaceNames() {
  const std::unique_ptr<struct if_nameindex, void (*)(struct if_nameindex*)> list(
      ::if_nameindex(), ::if_freenameindex);
  constexpr std::size_t kShown = 16;
  std::string names;
  std::size_t count = 0;
  for (const struct if_nameindex* each = list.get(); each != nullptr && each->if_index != 0;
       ++each, ++count) {
    if (count == kShown) return names + " ...";
    if (count > 0) names += ", ";
    names += each->if_name;
  }
  return count == 0 ? "none" : names;
}

}  // namespace rocinante
