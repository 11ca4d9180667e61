#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/packet/packet.h"

namespace rocinante {

/// The statement lines of `packet`, without their ends, byte for byte as in `text`, the datagram
/// that it was decoded from: of the devices that match one of `devices`, or of all when there are
/// no patterns (then also what is about no device; `erase` and `event` always). Lines that a reader
/// skips are left out, and so are lines that only a restatement by another program may hold
/// (`seen`). So are that program's events, which a reader ignores.
std::vector<std::string_view> statementLines(std::string_view text, const Packet& packet,
                                             const std::vector<std::string>& devices);

/// Packets of `header`, each with as many of the lines as fit into `mtu_bytes`, but at least one;
/// one packet without a statement for no lines. The header's SEQUENCE counts up from packet to
/// packet, and is afterwards the next one's.
std::vector<std::string> packetsOf(PacketHeader& header, const std::vector<std::string_view>& lines,
                                   std::size_t mtu_bytes);

}  // namespace rocinante
