#include "viewer/serve/access_rules.h"

#include <fmt/format.h>
#include <sodium.h>

#include <algorithm>
#include <array>

#include "core/base/plain_text.h"

namespace rocinante {
namespace {

std::string lowered(std::string_view text) {
  std::string lower(text);
  for (char& each : lower) {
    if (each >= 'A' && each <= 'Z') each = static_cast<char>(each - 'A' + 'a');
  }
  return lower;
}

/// HOST:PORT or [V6]:PORT; without a port, that of http.
struct HostPort {
  std::string host;
  std::string port;
};

HostPort splitHost(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  const std::size_t bracket = text.rfind(']');
  const bool has_port =
      colon != std::string_view::npos && (bracket == std::string_view::npos || colon > bracket);
  HostPort split;
  split.host = lowered(text.substr(0, has_port ? colon : text.size()));
  if (has_port) split.port = std::string(text.substr(colon + 1));
  return split;
}

bool isAddress(std::string_view host) {
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  return SocketAddress::parse(host, 0).ok();
}

std::array<unsigned char, crypto_generichash_BYTES> digestOf(std::string_view text) {
  std::array<unsigned char, crypto_generichash_BYTES> digest{};
  ::crypto_generichash(digest.data(), digest.size(),
                       reinterpret_cast<const unsigned char*>(text.data()), text.size(), nullptr,
                       0);
  return digest;
}

}  // namespace

bool sameSecret(std::string_view wanted, std::string_view given) {
  const auto a = digestOf(wanted);
  const auto b = digestOf(given);
  return ::sodium_memcmp(a.data(), b.data(), a.size()) == 0;
}

Result<AccessRules> AccessRules::of(std::uint16_t port, const std::vector<std::string>& names,
                                    const std::vector<std::string>& origins, std::string token,
                                    AddressFilter allow) {
  AccessRules rules;
  rules.port_ = port;
  for (const std::string& name : names) rules.names_.push_back(lowered(name));
  for (const std::string& origin : origins) {
    const std::string lower = lowered(origin);
    const std::size_t scheme = lower.find("://");
    const std::string_view host =
        scheme == std::string::npos ? "" : std::string_view(lower).substr(scheme + 3);
    if (host.empty() || host.find_first_of("/?#@ ") != std::string_view::npos ||
        lower != plainText(lower)) {
      return Error{ErrorKind::bad_argument,
                   "--origin takes SCHEME://HOST[:PORT], as browsers send it", origin};
    }
    rules.origins_.push_back(lower);
    rules.origin_hosts_.emplace_back(host);
  }
  rules.token_ = std::move(token);
  rules.allow_ = std::move(allow);
  return rules;
}

bool AccessRules::isOwnHost(std::string_view host) const {
  if (std::ranges::find(origin_hosts_, lowered(host)) != origin_hosts_.end()) return true;
  const HostPort split = splitHost(host);
  if ((split.port.empty() ? "80" : split.port) != std::to_string(port_)) return false;
  // An address cannot be made to lead elsewhere, as a name can.
  return split.host == "localhost" || isAddress(split.host) ||
         std::ranges::find(names_, split.host) != names_.end();
}

bool AccessRules::isOwnOrigin(const AccessRequest& request) const {
  const std::string origin = lowered(request.origin);
  if (std::ranges::find(origins_, origin) != origins_.end()) return true;
  const std::string host = lowered(request.host);
  return origin == "http://" + host || origin == "https://" + host;
}

bool AccessRules::hasToken(std::string_view token) const {
  return token_.empty() || sameSecret(token_, token);
}

std::optional<AccessRefusal> AccessRules::refusal(const AccessRequest& request) const {
  if (request.is_too_long) {
    return AccessRefusal{431, "The header Host or Origin is longer than any that may look here."};
  }
  if (!isOwnHost(request.host)) {
    return AccessRefusal{
        421, fmt::format("This server does not answer as {}. Open it by its address, or start "
                         "rocinante serve with --origin http://HOST:PORT.",
                         request.host.empty() ? "a host without a name" : request.host)};
  }
  if (!request.origin.empty() && !isOwnOrigin(request)) {
    return AccessRefusal{403,
                         fmt::format("Pages of {} may not look at this server. Start rocinante "
                                     "serve with --origin {} to let them.",
                                     request.origin, request.origin)};
  }
  if (!hasToken(request.token)) {
    return AccessRefusal{401, request.token.empty()
                                  ? "This server asks for a token: open it with ?token=TOKEN."
                                  : "The token is not this server's."};
  }
  return {};
}

}  // namespace rocinante
