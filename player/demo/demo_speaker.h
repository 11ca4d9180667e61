#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/packet/packet_text.h"
#include "core/packet/session_state.h"
#include "player/demo/demo_motion.h"

namespace rocinante {

/// One source of the demo: numbers and timestamps its datagrams, keeps them within the MTU, and
/// remembers its state to restate it.
class DemoSpeaker {
 public:
  /// `options` must outlive it.
  DemoSpeaker(DemoPart part, const DemoOptions& options, std::uint64_t first_sequence);

  /// Sends the statements in one datagram, or in several when they exceed the MTU. `at` must not go
  /// back.
  void say(Nanoseconds at, const std::vector<Statement>& statements);

  /// Restates everything that this source owns, as one complete restatement.
  void sayAgain(Nanoseconds at);

  std::vector<DemoDatagram> take() { return std::move(datagrams_); }

 private:
  PacketHeader header(Nanoseconds at) const;
  void send(Nanoseconds at, std::string payload);

  DemoPart part_;
  const DemoOptions& options_;
  std::uint64_t sequence_ = 0;
  std::uint64_t restatements_ = 0;
  PacketTextDecoder decoder_;
  SessionState state_;
  std::vector<DemoDatagram> datagrams_;
};

}  // namespace rocinante
