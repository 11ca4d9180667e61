#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "core/base/playback_speed.h"
#include "core/base/result.h"
#include "core/net/endpoint.h"
#include "player/send/datagram_stream.h"
#include "player/send/play_report.h"
#include "player/send/realtime.h"

namespace rocinante {

/// What a running sender asks of and tells its surroundings.
struct SendSurroundings {
  std::function<bool()> stop;                  ///< asked often; true ends the sending
  std::function<void(std::string_view)> told;  ///< one line for a person
};

/// Where and how fast a stream is to be sent.
struct SendPlan {
  Endpoint to;
  std::optional<PlaybackSpeed> speed;  ///< empty: without a schedule
  LogTime first{};                     ///< the moment that is due first
  LogTime from{}, until{};             ///< one turn: what the report calls a span
  LogTime origin{};                    ///< that the progress line counts from
  LogTime last{};                      ///< the end that the progress line shows
  Realtime realtime = Realtime::automatic;
  bool progress = false;
  std::function<void()> began;  ///< called once the socket is there; may be empty
};

/// Opens the socket, makes the calling thread the pacing one, sends `stream` and fills all of the
/// report but its inputs and damage. Returns when all is sent or `stop` says so.
Result<PlayReport> sendPlan(DatagramStream& stream, const SendPlan& plan,
                            const std::function<bool()>& stop);

}  // namespace rocinante
