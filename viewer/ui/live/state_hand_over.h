#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/time.h"
#include "core/packet/decoder.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// Packets that one fold has applied and another will: what was said, not what is. So the cost of
/// handing a state over is that of what changed, however many devices the session has. A value:
/// made on one thread, applied on another.
class StateChanges {
 public:
  /// Adds a packet as received. False, and nothing is added, when that would cost more than a copy
  /// of `state`, the fold of it and everything before: then the whole state has to be handed over.
  bool add(LogTime time, ByteView packet, const SessionState& state);
  /// Hands over a copy of the state instead of packets.
  void replaceBy(const SessionState& state);

  bool empty() const { return !whole_ && packets_.empty(); }
  /// Brings `state`, which has everything that was handed over before, up to date.
  void applyTo(SessionState& state, Decoder& decoder) &&;
  /// Forgets everything, keeping the memory for the next changes.
  void clear();

 private:
  struct Packet {
    LogTime time;
    std::uint32_t offset = 0;  ///< in bytes_
    std::uint32_t length = 0;
  };

  std::optional<SessionState> whole_;
  std::vector<Packet> packets_;
  Bytes bytes_;
};

}  // namespace rocinante
