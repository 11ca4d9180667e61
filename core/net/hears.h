#pragma once

#include <string>

#include "core/net/datagram_source.h"

namespace rocinante {

/// True when the source receives what is sent to `to`: the same address, or overlapping subjects of
/// one NATS server, however each names it; `to_server` is the sink's serverId(). Watched traffic
/// (pcap://) is another matter: what a program sent itself is known there by its sender.
bool hears(const DatagramSource& source, const Endpoint& to, const std::string& to_server);

/// The same of an address that is listened at and an endpoint that is sent to.
bool hears(const Endpoint& from, const SocketAddress& bound, const Endpoint& to);

}  // namespace rocinante
