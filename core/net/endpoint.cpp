#include "core/net/endpoint.h"

#include <net/if.h>
#include <netdb.h>
#include <netinet/in.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <utility>

#include "core/base/plain_text.h"
#include "core/net/endpoint_text.h"
#include "core/net/system_socket.h"

namespace rocinante {
namespace {

// A host name has at most 253 bytes, each of two patterns 255, written as three each.
constexpr std::size_t kMaxTextBytes = 2'048;

Error bad(std::string_view text, std::string_view reason) { return badEndpoint(text, reason); }

template <class Number>
std::optional<Number> decimal(std::string_view text) {
  // from_chars would accept "007" too, and then text() would not return the input.
  if (text.empty() || (text.size() > 1 && text[0] == '0')) return std::nullopt;
  Number number{};
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// As in URLs: a last label that begins with a digit makes the host a number, never a name to look
/// up.
bool looksNumeric(std::string_view host) {
  const std::size_t dot = host.find_last_of('.');
  const std::string_view last = dot == host.npos ? host : host.substr(dot + 1);
  return !last.empty() && isDigit(last[0]);
}

/// The first IPv4 address of a name, else its first IPv6 address: a sender and a receiver that use
/// the same name must meet, and [::1] and 127.0.0.1 do not.
Result<SocketAddress> lookUp(std::string_view name, std::uint16_t port, std::string_view text) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_DGRAM;
  addrinfo* first = nullptr;
  const int fault = ::getaddrinfo(std::string(name).c_str(), nullptr, &hints, &first);
  if (fault != 0) {
    return Error{ErrorKind::refused,
                 "cannot look up " + printableEndpoint(name) + ": " + ::gai_strerror(fault),
                 printableEndpoint(text)};
  }
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> list(first, ::freeaddrinfo);
  const addrinfo* chosen = first;
  for (const addrinfo* each = first; each != nullptr; each = each->ai_next) {
    if (each->ai_family == AF_INET) {
      chosen = each;
      break;
    }
  }
  sockaddr_storage system{};
  std::copy_n(reinterpret_cast<const char*>(chosen->ai_addr), chosen->ai_addrlen,
              reinterpret_cast<char*>(&system));
  SocketAddress address = fromSystem(system);
  address.port = port;
  return address;
}

Status checkScheme(std::string_view scheme, std::string_view text) {
  if (scheme == "udp") return {};
  return bad(text, "an endpoint begins with udp:// or is HOST:PORT or :PORT");
}

}  // namespace

Result<SocketAddress> parseHostPort(std::string_view host_port, std::string_view text,
                                    HostNames names) {
  std::string_view host;
  std::string_view port_text;
  const bool bracketed = host_port.starts_with('[');
  if (bracketed) {
    const std::size_t close = host_port.find(']');
    if (close == host_port.npos) return bad(text, "the bracket of an IPv6 address is not closed");
    host = host_port.substr(1, close - 1);
    port_text = host_port.substr(close + 1);
  } else {
    const std::size_t colon = host_port.find(':');
    if (colon != host_port.rfind(':')) {
      return bad(text, "an IPv6 address must be in brackets, as in [::1]:19960");
    }
    host = host_port.substr(0, colon);
    port_text = colon == host_port.npos ? std::string_view() : host_port.substr(colon);
  }
  if (port_text.empty()) {
    const std::string_view end = host.substr(std::min(host.rfind('.'), host.size()));
    if (end == ".pcap" || end == ".pcapng") {
      return bad(text, "a capture file is given as pcap://./FILE");
    }
    return bad(text, "an endpoint needs a port, as in HOST:19960");
  }
  if (port_text[0] != ':') return bad(text, "expected a colon and the port after the address");
  const auto port = decimal<std::uint16_t>(port_text.substr(1));
  if (!port) return bad(text, "a port is a whole number from 0 to 65535");

  if (bracketed) {
    if (host.find(':') == host.npos) return bad(text, "brackets are for IPv6 addresses");
    auto address = SocketAddress::parse(host, *port);
    if (!address) return bad(text, address.error().what);
    if (address->isLinkLocal() && address->scope_id == 0) {
      return bad(text, "a link-local address needs its interface, as in [fe80::1%eth0]:19960");
    }
    return address;
  }
  if (host.empty()) return SocketAddress{.port = *port};
  if (!isHostName(host)) return bad(text, "the host is neither an address nor a name");
  if (!looksNumeric(host)) {
    if (names == HostNames::looked_up) return lookUp(host, *port, text);
    return Error{ErrorKind::refused, "a name is not looked up here", printableEndpoint(text)};
  }
  auto address = SocketAddress::parse(host, *port);
  if (!address) return bad(text, address.error().what);
  return address;
}

namespace {

Status setInterface(Endpoint& endpoint, std::string_view name, std::string_view text) {
  if (!endpoint.isMulticast()) return bad(text, "interface= is for multicast groups only");
  if (!isInterfaceName(name))
    return bad(text, "interface= takes the name of a network interface, such as eth0");
  endpoint.interface = name;
  return {};
}

Status setTtl(Endpoint& endpoint, std::string_view number, std::string_view text) {
  const auto ttl = decimal<std::uint8_t>(number);
  if (!ttl) return bad(text, "ttl= is a whole number from 0 to 255");
  endpoint.ttl = *ttl;
  return {};
}

Status setSource(Endpoint& endpoint, std::string_view host, std::string_view text) {
  if (!endpoint.isMulticast()) return bad(text, "source= is for multicast groups only");
  const auto source = SocketAddress::parse(host, 0);
  if (!source) return bad(text, "source= takes an address: " + source.error().what);
  if (source->is_ipv6 != endpoint.address.is_ipv6) {
    return bad(text, "source= and the group must both be IPv4 or both IPv6");
  }
  if (source->isMulticast() || source->isAny()) {
    return bad(text, "source= takes the address of one sender");
  }
  endpoint.source = *source;
  return {};
}

Status setOption(Endpoint& endpoint, std::string_view option, std::string_view text) {
  const std::size_t equals = option.find('=');
  const std::string_view name = option.substr(0, equals);
  const std::string_view value =
      equals == option.npos ? std::string_view() : option.substr(equals + 1);
  const bool given_before = (name == "interface" && !endpoint.interface.empty()) ||
                            (name == "ttl" && endpoint.ttl) ||
                            (name == "source" && endpoint.source);
  if (given_before) return bad(text, std::string(name) + "= is given twice");
  if (name == "interface") return setInterface(endpoint, value, text);
  if (name == "ttl") return setTtl(endpoint, value, text);
  if (name == "source") return setSource(endpoint, value, text);
  return bad(text, "the options of an endpoint are interface=, ttl= and source=");
}

/// [ff02::1%eth0] and ?interface=eth0 mean the same; the second is the canonical form.
Status moveZoneToInterface(Endpoint& endpoint, std::string_view text) {
  if (!endpoint.isMulticast() || endpoint.address.scope_id == 0) return {};
  char name[IF_NAMESIZE] = {};
  if (::if_indextoname(endpoint.address.scope_id, name) == nullptr) {
    return bad(text, "the zone after % names no network interface here");
  }
  endpoint.address.scope_id = 0;
  endpoint.interface = name;
  return {};
}

Result<Endpoint> parseEndpoint(std::string_view text, HostNames names) {
  if (text.empty()) return bad(text, "an endpoint is udp://HOST:PORT, HOST:PORT or :PORT");
  if (text.size() > kMaxTextBytes) return bad(text, "the endpoint is too long");
  std::string_view rest = text;
  if (rest.starts_with(kPcapScheme)) return parsePcap(text);
  if (rest.starts_with(kSubscribeScheme)) return parseSubscribe(text, names);
  if (rest.starts_with(kNatsScheme) || rest.starts_with(kJetStreamScheme)) return parseNats(text);
  if (const std::size_t scheme_end = rest.find("://"); scheme_end != rest.npos) {
    if (Status known = checkScheme(rest.substr(0, scheme_end), text); !known) return known.error();
    rest.remove_prefix(scheme_end + 3);
  }
  const std::size_t question = rest.find('?');
  auto address = parseHostPort(rest.substr(0, question), text, names);
  if (!address) return address.error();

  Endpoint endpoint;
  endpoint.address = *address;
  if (Status moved = moveZoneToInterface(endpoint, text); !moved) return moved.error();
  while (rest.find_first_of("?&") != rest.npos) {
    rest.remove_prefix(rest.find_first_of("?&") + 1);
    const std::string_view option = rest.substr(0, rest.find('&'));
    if (Status set = setOption(endpoint, option, text); !set) return set.error();
  }
  return endpoint;
}

}  // namespace

bool isHostName(std::string_view host) {
  return !host.empty() && host.size() <= 253 && std::all_of(host.begin(), host.end(), [](char c) {
    return isDigit(c) || isLetter(c) || c == '-' || c == '.' || c == '_';
  });
}

std::string printableEndpoint(std::string_view text) {
  // A password or a token is shown nowhere, however malformed the rest is.
  const std::size_t scheme = text.find("://");
  if (const std::size_t at = text.rfind('@');
      scheme < at && at != text.npos && !text.starts_with(kPcapScheme)) {
    return printableEndpoint(std::string(text.substr(0, scheme + 3)) +
                             std::string(text.substr(at + 1)));
  }
  // A byte may become four characters, \xNN.
  std::string shown = plainText(text.substr(0, 100));
  return shown.size() <= 100 ? shown : plainText(text.substr(0, 25));
}

Error badEndpoint(std::string_view text, std::string_view reason) {
  return {ErrorKind::bad_argument, std::string(reason), printableEndpoint(text)};
}

bool isInterfaceName(std::string_view name) {
  return !name.empty() && name.size() < IF_NAMESIZE &&
         std::all_of(name.begin(), name.end(), [](char c) {
           return c > ' ' && c <= '~' &&
                  std::string_view("/&?#%=").find(c) == std::string_view::npos;
         });
}

Result<Endpoint> Endpoint::parse(std::string_view text) {
  return parseEndpoint(text, HostNames::looked_up);
}

Status Endpoint::check(std::string_view text) {
  const auto endpoint = parseEndpoint(text, HostNames::left);
  if (endpoint.ok() || endpoint.error().kind == ErrorKind::refused) return {};
  return endpoint.error();
}

Endpoint Endpoint::standard() {
  Endpoint endpoint;
  endpoint.address.address = {239, 255, 19, 96};
  endpoint.address.port = 19'960;
  endpoint.interface = "lo";
  endpoint.ttl = 0;
  return endpoint;
}

std::string Endpoint::text() const {
  if (isPcap()) return pcapText(*this);
  if (isSubscription()) return subscribeText(*this);
  if (isNats()) return natsText(*this);
  std::string text = "udp://" + address.text();
  char mark = '?';
  const auto add = [&](std::string_view name, std::string_view value) {
    text += std::exchange(mark, '&');
    text += name;
    text += value;
  };
  if (!interface.empty()) add("interface=", interface);
  if (ttl) add("ttl=", std::to_string(*ttl));
  if (source) add("source=", source->hostText());
  return text;
}

}  // namespace rocinante
