#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/playback_speed.h"
#include "core/base/result.h"
#include "core/net/endpoint.h"
#include "player/logs/multi_log_reader.h"
#include "player/logs/play_routes.h"
#include "player/playhead/playhead_sender.h"
#include "player/send/play_report.h"
#include "player/send/realtime.h"
#include "player/send/send_plan.h"

namespace rocinante {

struct PlayOptions {
  std::vector<std::filesystem::path> logs;  ///< played on one time line; at least one
  ChannelChoice channels;
  Endpoint to = Endpoint::standard();
  std::vector<RouteMap> maps;  ///< the first that matches a topic counts
  bool keep_ports = false;     ///< send from the ports of the original senders
  PlaybackSpeed speed;
  bool at_once = false;   ///< without a schedule
  bool lockstep = false;  ///< without a schedule: each message waits for an ack
  Nanoseconds ack_timeout = std::chrono::seconds(1);
  std::optional<std::string> from;       ///< session times (core/session/timeline.h), half open;
  std::optional<std::string> until;      ///< by default all
  std::uint32_t turns = 1;               ///< 0: endless
  std::optional<std::string> loop;       ///< "A-B", session times: played endlessly once reached
  std::optional<Nanoseconds> gap_limit;  ///< real time
  bool start_paused = false;
  bool restate = true;                           ///< at the start, after a seek, at each turn
  Nanoseconds repeat = std::chrono::seconds(2);  ///< real time between restatements; 0: no more
  bool stays = false;                            ///< at the end it waits for commands
  Realtime realtime = Realtime::automatic;
  bool progress = false;  ///< a progress line on stderr
};

/// Who commands a running player.
struct PlayControl {
  CommandSource* commands = nullptr;
  int wake = -1;  ///< readable when a command has come
};

/// Re-emits logs as UDP (docs/programs/play.md). Returns when all is sent, `stop` says so, or a
/// command to quit came. not_found when no captured message lies in the span; else fails as the
/// logs and the sockets do when they are opened. What goes wrong later is in the report's
/// `failure`.
Result<PlayReport> play(const PlayOptions& options, const SendSurroundings& surroundings,
                        const PlayControl& control = {});

/// "A-B": two session times. bad_argument when there is no place to cut it.
Result<PlayedSpan> parseLoop(std::string_view text, LogTime origin, LogTime end);

}  // namespace rocinante
