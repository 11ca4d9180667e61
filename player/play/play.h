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
  std::vector<std::filesystem::path> logs;  ///< on one time line; at least one
  ChannelChoice channels;
  Endpoint to = Endpoint::standard();
  std::vector<RouteMap> maps;  ///< the first that matches a topic is used
  bool keep_ports = false;     ///< send from the ports of the original senders
  PlaybackSpeed speed;
  bool at_once = false;   ///< without a schedule
  bool lockstep = false;  ///< without a schedule: each message waits for an ack
  Nanoseconds ack_timeout = std::chrono::seconds(1);
  std::optional<std::string> from;   ///< session times (core/session/timeline.h), [from, until);
  std::optional<std::string> until;  ///< empty: all
  std::uint32_t turns = 1;           ///< 0: endless
  std::optional<std::string> loop;   ///< "A-B", session times: repeated endlessly once reached
  std::optional<Nanoseconds> gap_limit;  ///< real time
  bool start_paused = false;
  bool restate = true;                           ///< at the start, after a seek, at each turn
  Nanoseconds repeat = std::chrono::seconds(2);  ///< real time between restatements; 0: none
  bool stays = false;                            ///< wait for commands at the end
  std::filesystem::path key;                     ///< signs the restatements; empty: unsigned
  Realtime realtime = Realtime::automatic;
  bool progress = false;  ///< a progress line on stderr
};

/// The control of a running player.
struct PlayControl {
  CommandSource* commands = nullptr;
  int wake = -1;  ///< readable when a command is waiting
};

/// Re-emits logs as UDP (docs/programs/play.md). Returns when everything is sent, `stop` returns
/// true, or a command quits. not_found without a captured message in the span; otherwise fails as
/// opening the logs and sockets does. Later failures are in the report's `failure`.
Result<PlayReport> play(const PlayOptions& options, const SendSurroundings& surroundings,
                        const PlayControl& control = {});

/// Parses "A-B", two session times. bad_argument when it cannot be split.
Result<PlayedSpan> parseLoop(std::string_view text, LogTime origin, LogTime end);

}  // namespace rocinante
