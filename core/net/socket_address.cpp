#include <arpa/inet.h>
#include <fmt/format.h>
#include <net/if.h>
#include <netinet/in.h>

#include <algorithm>
#include <charconv>
#include <cstring>

#include "core/net/endpoint.h"

namespace rocinante {
namespace {

Error badAddress(std::string_view host, std::string_view reason) {
  return {ErrorKind::bad_argument, std::string(reason), std::string(host)};
}

/// A zone is an interface's name, or its index.
std::optional<std::uint32_t> zoneIndex(const std::string& zone) {
  if (const unsigned index = ::if_nametoindex(zone.c_str()); index != 0) return index;
  std::uint32_t index = 0;
  const char* end = zone.data() + zone.size();
  const auto [used, fault] = std::from_chars(zone.data(), end, index);
  if (fault != std::errc() || used != end || index == 0) return std::nullopt;
  return index;
}

}  // namespace

Result<SocketAddress> SocketAddress::parse(std::string_view host, std::uint16_t port) {
  SocketAddress parsed;
  parsed.port = port;
  // inet_pton stops at a NUL, so an embedded one would hide the rest.
  if (host.find('\0') != host.npos) return badAddress("", "an address must not contain NUL");
  const std::size_t percent = host.find('%');
  const std::string number(host.substr(0, percent));
  if (number.find(':') == number.npos) {
    if (percent != host.npos || ::inet_pton(AF_INET, number.c_str(), parsed.address.data()) != 1) {
      return badAddress(host, "an IPv4 address is four numbers from 0 to 255 separated by dots");
    }
    return parsed;
  }
  parsed.is_ipv6 = true;
  if (::inet_pton(AF_INET6, number.c_str(), parsed.address.data()) != 1) {
    return badAddress(host, "this is not an IPv6 address");
  }
  if (percent == host.npos) return parsed;
  if (!parsed.isLinkLocal() && !parsed.isMulticast()) {
    return badAddress(host, "only a link-local IPv6 address takes a zone");
  }
  const std::optional<std::uint32_t> zone = zoneIndex(std::string(host.substr(percent + 1)));
  if (!zone) return badAddress(host, "the zone after % names no network interface here");
  parsed.scope_id = *zone;
  return parsed;
}

bool SocketAddress::isLinkLocal() const {
  return is_ipv6 && address[0] == 0xFE && (address[1] & 0xC0) == 0x80;
}

bool SocketAddress::isMulticast() const {
  return is_ipv6 ? address[0] == 0xFF : (address[0] & 0xF0) == 0xE0;
}

bool SocketAddress::isAny() const {
  return std::all_of(address.begin(), address.end(), [](std::uint8_t byte) { return byte == 0; });
}

std::string SocketAddress::hostText() const {
  char text[INET6_ADDRSTRLEN] = {};
  ::inet_ntop(is_ipv6 ? AF_INET6 : AF_INET, address.data(), text, sizeof text);
  std::string host = text;
  if (is_ipv6 && scope_id != 0) {
    char name[IF_NAMESIZE] = {};
    host += '%';
    host += ::if_indextoname(scope_id, name) != nullptr ? name : std::to_string(scope_id);
  }
  return host;
}

std::string SocketAddress::text() const {
  return is_ipv6 ? fmt::format("[{}]:{}", hostText(), port)
                 : fmt::format("{}:{}", hostText(), port);
}

}  // namespace rocinante
