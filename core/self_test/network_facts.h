#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/self_test/fact.h"

namespace rocinante {

/// What the network of this machine gives to the programs. Each opens sockets of its own on free
/// ports, so that no listener on this machine hears of it, and waits a second at most. `programs`:
/// the folder that ours lie in, for the advice.

/// A datagram to the standard group comes back through the loopback interface.
SelfTestFact multicastFact();
/// A datagram to [::1] does.
SelfTestFact ipv6Fact();
/// What the kernel grants of the receive buffer that listeners ask for.
SelfTestFact receiveBufferFact();
/// The right to watch traffic (pcap://).
SelfTestFact captureFact(const std::filesystem::path& programs);

/// The decision of receiveBufferFact(): bytes as the kernel counts them, twice what was asked for.
SelfTestFact judgeReceiveBuffer(std::uint64_t granted_bytes, std::uint64_t asked_bytes);

}  // namespace rocinante
