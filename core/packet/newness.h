#pragma once

#include <cstdint>

#include "core/packet/packet.h"
#include "core/packet/packet_limits.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// How newest-wins sees a datagram of a source (docs/packet-format.md, "Newest wins").
enum class Newness : std::uint8_t {
  newest,   ///< it is applied
  restart,  ///< it is applied, after the SEQUENCE that is remembered was forgotten
  late,     ///< it is dropped
};

/// What SessionState::apply() would make of a packet with this header, but for its limits.
Newness newnessOf(const SessionState& state, const PacketHeader& header);

/// True for a source's own SEQUENCE that begins anew instead of being late.
inline bool isRestart(std::uint64_t sequence, std::uint64_t highest) {
  return sequence == 0 || (sequence < highest && highest - sequence > limits::kReorderWindow);
}

}  // namespace rocinante
