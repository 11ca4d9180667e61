#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/log/log_types.h"
#include "core/packet/decoder.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// Applies a decoded packet. Its events are appended to `events`, or dropped when there is none: in
/// the state they would accumulate.
Applied foldPacket(SessionState& state, LogTime time, const Packet& packet,
                   std::vector<Event>* events = nullptr);

/// Folds the messages of logs into states, each by the decoder of its encoding (docs/log-format.md,
/// "Channels"). Holds the decoders' scratch memory: one per thread.
class MessageFolder {
 public:
  /// The decoder of a channel's messages; null when they are not folded or of an unknown encoding.
  /// Valid while the folder lives.
  Decoder* decoderOf(const LogChannel& channel);

  /// The packet in a message; null when it is not folded or holds none. Its views stay valid until
  /// the next call, and while the message's payload does.
  const Packet* decode(const LogMessage& message);

  struct Folded {
    const Packet* packet = nullptr;  ///< null: not folded, or not a packet
    bool applied = false;            ///< false also when the packet came late
  };
  /// Decodes the message and applies it as foldPacket() does.
  Folded fold(SessionState& state, const LogMessage& message, std::vector<Event>* events = nullptr);

 private:
  std::map<std::string, std::unique_ptr<Decoder>, std::less<>> decoders_;
};

}  // namespace rocinante
