#pragma once

#include <functional>
#include <string_view>

#include "core/base/playback_speed.h"
#include "core/base/result.h"
#include "core/net/endpoint.h"
#include "player/send/datagram_stream.h"
#include "player/send/play_report.h"
#include "player/send/realtime.h"

namespace rocinante {

/// Callbacks of a running sender.
struct SendSurroundings {
  std::function<bool()> stop;                    ///< polled often; true ends sending
  std::function<void(std::string_view)> notify;  ///< receives one line for the user
};

/// Where and how fast to send a stream.
struct SendPlan {
  Endpoint to;
  PlaybackSpeed speed;
  LogTime first{};          ///< the first due moment
  LogTime from{}, until{};  ///< one turn: a span in the report
  LogTime origin{};         ///< reference of the progress line
  LogTime last{};           ///< end shown by the progress line
  Realtime realtime = Realtime::automatic;
  bool progress = false;
  std::function<void(std::string_view)> notify;  ///< receives one line for the user; may be empty
  std::function<void()> began;                   ///< called once the socket is open; may be empty
};

/// Opens the socket, paces in the calling thread, sends `stream` and fills the report except its
/// inputs and damage. Returns when everything is sent or `stop` returns true.
Result<PlayReport> sendPlan(DatagramStream& stream, const SendPlan& plan,
                            const std::function<bool()>& stop);

}  // namespace rocinante
