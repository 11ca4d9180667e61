#pragma once

#include "core/base/result.h"
#include "core/packet/packet_text.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// The state of a live session in a page: folds what a server sends (viewer/web/live_message.h).
/// One thread.
class WebLive {
 public:
  /// damaged when the message is malformed; what came before the fault counts.
  Status take(ByteView message);

  const SessionState& state() const { return state_; }
  /// Of the newest message.
  LogTime time() const { return time_; }
  /// Of the first message.
  LogTime origin() const { return origin_; }
  bool greeted() const { return greeted_; }

 private:
  PacketTextDecoder decoder_;
  SessionState state_;
  LogTime time_{}, origin_{};
  bool greeted_ = false;
};

}  // namespace rocinante
