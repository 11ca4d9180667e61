#pragma once

#include <string>
#include <string_view>

#include "core/net/endpoint.h"

namespace rocinante {

/// Shared by the readers of endpoints (endpoint.cpp, pcap_endpoint.cpp); for core/net's own
/// sources.

constexpr std::string_view kPcapScheme = "pcap://";

/// `text` as it may appear in an error: short, and without control characters.
std::string printableEndpoint(std::string_view text);
/// A bad_argument error with the text.
Error badEndpoint(std::string_view text, std::string_view reason);
/// A name that the system accepts, without a character that has a meaning in an endpoint.
bool isInterfaceName(std::string_view name);

/// pcap://INTERFACE?filter=EXPR or pcap://PATH; `text` begins with kPcapScheme.
Result<Endpoint> parsePcap(std::string_view text);
/// The canonical form of a pcap endpoint.
std::string pcapText(const Endpoint& endpoint);

}  // namespace rocinante
