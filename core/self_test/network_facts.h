#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/self_test/fact.h"

namespace rocinante {

/// Facts about the network of this machine. Each check opens its own sockets on free ports, so that
/// it disturbs no listener, and waits at most a second. `programs`: the folder of our programs, for
/// the advice.

/// A datagram to the standard group comes back through the loopback interface.
SelfTestFact multicastFact();
/// A datagram to [::1] does.
SelfTestFact ipv6Fact();
/// How much of the requested receive buffer the kernel grants.
SelfTestFact receiveBufferFact();
/// The right to watch traffic (pcap://).
SelfTestFact captureFact(const std::filesystem::path& programs);

/// The decision of receiveBufferFact(): bytes as the kernel counts them, twice what was asked for.
SelfTestFact judgeReceiveBuffer(std::uint64_t granted_bytes, std::uint64_t asked_bytes);

}  // namespace rocinante
