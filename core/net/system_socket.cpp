#include "core/net/system_socket.h"

#include <net/if.h>
#include <netinet/in.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/net/interfaces.h"

namespace rocinante {

socklen_t toSystem(const SocketAddress& address, sockaddr_storage& system) {
  system = {};
  if (address.is_ipv6) {
    sockaddr_in6 in6{};
    in6.sin6_family = AF_INET6;
    in6.sin6_port = htons(address.port);
    in6.sin6_scope_id = address.scope_id;
    std::memcpy(&in6.sin6_addr, address.address.data(), 16);
    std::memcpy(&system, &in6, sizeof in6);
    return sizeof in6;
  }
  sockaddr_in in{};
  in.sin_family = AF_INET;
  in.sin_port = htons(address.port);
  std::memcpy(&in.sin_addr, address.address.data(), 4);
  std::memcpy(&system, &in, sizeof in);
  return sizeof in;
}

SocketAddress fromSystem(const sockaddr_storage& system) {
  SocketAddress address;
  if (system.ss_family == AF_INET6) {
    sockaddr_in6 in6{};
    std::memcpy(&in6, &system, sizeof in6);
    address.is_ipv6 = true;
    std::memcpy(address.address.data(), &in6.sin6_addr, 16);
    address.port = ntohs(in6.sin6_port);
    address.scope_id = in6.sin6_scope_id;
  } else if (system.ss_family == AF_INET) {
    sockaddr_in in{};
    std::memcpy(&in, &system, sizeof in);
    std::memcpy(address.address.data(), &in.sin_addr, 4);
    address.port = ntohs(in.sin_port);
  }
  return address;
}

Result<SystemSocket> SystemSocket::open(const Endpoint& endpoint) {
  if (endpoint.isPcap()) {
    return Error{ErrorKind::bad_argument,
                 "pcap:// only watches: record, spy, check --live and view --live take it",
                 endpoint.text()};
  }
  if (endpoint.isSubscription()) {
    return Error{ErrorKind::bad_argument,
                 "subscribe:// only receives: record, spy, check --live and view --live take it",
                 endpoint.text()};
  }
  if (endpoint.isNats()) {
    return Error{ErrorKind::bad_argument, "this takes udp:// endpoints only", endpoint.text()};
  }
  const int family = endpoint.address.is_ipv6 ? AF_INET6 : AF_INET;
  const int descriptor = ::socket(family, SOCK_DGRAM | SOCK_CLOEXEC, IPPROTO_UDP);
  if (descriptor < 0) return systemError("cannot make a UDP socket", endpoint);
  return SystemSocket(descriptor);
}

SystemSocket::~SystemSocket() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

SystemSocket::SystemSocket(SystemSocket&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)) {}

SystemSocket& SystemSocket::operator=(SystemSocket&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

bool SystemSocket::setOption(int level, int name, int value) {
  return ::setsockopt(descriptor_, level, name, &value, sizeof value) == 0;
}

Result<SocketAddress> SystemSocket::localAddress(const Endpoint& endpoint) const {
  sockaddr_storage system{};
  socklen_t length = sizeof system;
  if (::getsockname(descriptor_, reinterpret_cast<sockaddr*>(&system), &length) != 0) {
    return systemError("cannot read the socket's own address", endpoint);
  }
  return fromSystem(system);
}

Error systemError(std::string_view what, const Endpoint& endpoint) {
  return {ErrorKind::refused, std::string(what) + ": " + std::strerror(errno), endpoint.text()};
}

Result<unsigned> interfaceIndex(const Endpoint& endpoint) {
  if (endpoint.interface.empty()) return 0U;
  const unsigned index = ::if_nametoindex(endpoint.interface.c_str());
  if (index == 0) {
    return Error{
        ErrorKind::refused,
        "there is no network interface " + endpoint.interface + "; there are " + interfaceNames(),
        endpoint.text()};
  }
  return index;
}

}  // namespace rocinante
