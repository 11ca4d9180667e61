#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/net/endpoint.h"

namespace rocinante {

/// Shared by the readers of endpoints (endpoint.cpp, nats_endpoint.cpp, pcap_endpoint.cpp,
/// subscribe_endpoint.cpp); for core/net's own sources.

constexpr std::string_view kPcapScheme = "pcap://";
constexpr std::string_view kSubscribeScheme = "subscribe://";
constexpr std::string_view kNatsScheme = "nats://";
constexpr std::string_view kJetStreamScheme = "jetstream://";

/// `text` as it may appear in an error: short, without control characters and
/// without what precedes an @.
std::string printableEndpoint(std::string_view text);
/// A bad_argument error with the text.
Error badEndpoint(std::string_view text, std::string_view reason);
/// A name that the system accepts, without a character that has a meaning in an endpoint.
bool isInterfaceName(std::string_view name);
/// A name that may be looked up, or an IPv4 address.
bool isHostName(std::string_view host);

/// Decodes %XX as in URLs. Empty when a % is malformed, or the bytes hold a NUL, CR or LF.
std::optional<std::string> decodePercent(std::string_view text);
/// One word for any text: bytes that are not printable, % and those of `also`, as %XX.
std::string encodePercent(std::string_view text, std::string_view also);
/// What is done with a host name. That it is not looked up is a `refused`, as that it is not found.
enum class HostNames { looked_up, left };
/// HOST:PORT, [V6]:PORT or :PORT. `text` is the whole endpoint, for errors.
Result<SocketAddress> parseHostPort(std::string_view host_port, std::string_view text,
                                    HostNames names);

/// subscribe://HOST:PORT?OPTIONS; `text` begins with kSubscribeScheme.
Result<Endpoint> parseSubscribe(std::string_view text, HostNames names);
/// The canonical form of a subscribe endpoint.
std::string subscribeText(const Endpoint& endpoint);

/// pcap://INTERFACE?filter=EXPR or pcap://PATH; `text` begins with kPcapScheme.
Result<Endpoint> parsePcap(std::string_view text);
/// The canonical form of a pcap endpoint.
std::string pcapText(const Endpoint& endpoint);

/// nats://... or jetstream://...; `text` begins with one of the two.
Result<Endpoint> parseNats(std::string_view text);
/// The canonical form of a nats or jetstream endpoint, without user, password and token.
std::string natsText(const Endpoint& endpoint);

}  // namespace rocinante
