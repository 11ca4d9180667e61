#pragma once

#include <string>
#include <string_view>

#include "core/net/endpoint.h"

namespace rocinante {

/// What the readers of endpoints share (endpoint.cpp, pcap_endpoint.cpp); for core/net's own
/// sources.

constexpr std::string_view kPcapScheme = "pcap://";

/// `text` as an error may show it: short, and without control characters.
std::string printableEndpoint(std::string_view text);
/// bad_argument, with the text.
Error badEndpoint(std::string_view text, std::string_view reason);
/// Such as the system takes, and no character that has a meaning in an endpoint.
bool isInterfaceName(std::string_view name);

/// pcap://INTERFACE?filter=EXPR or pcap://PATH, of which `text` begins with kPcapScheme.
Result<Endpoint> parsePcap(std::string_view text);
/// The canonical form of a pcap endpoint.
std::string pcapText(const Endpoint& endpoint);

}  // namespace rocinante
