#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/net/endpoint.h"
#include "core/playback_speed.h"
#include "core/result.h"
#include "player/play_report.h"
#include "player/realtime.h"
#include "player/send_plan.h"

namespace rocinante {

struct PlayOptions {
  std::vector<std::filesystem::path> logs;  ///< played on one time line; at least one
  Endpoint to = Endpoint::standard();
  PlaybackSpeed speed;
  bool at_once = false;              ///< without a schedule
  std::optional<std::string> from;   ///< session times (core/session/timeline.h), half open;
  std::optional<std::string> until;  ///< by default all
  std::uint32_t turns = 1;           ///< 0: endless
  bool restate = true;
  Realtime realtime = Realtime::automatic;
  bool progress = false;  ///< a progress line on stderr
};

/// Re-emits logs as UDP (docs/programs/play.md). Returns when all is sent or `stop` says so.
/// not_found when no captured message lies in the span; else fails as the logs and the socket do.
Result<PlayReport> play(const PlayOptions& options, const SendSurroundings& surroundings);

}  // namespace rocinante
