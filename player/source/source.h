#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/playback_speed.h"
#include "core/base/result.h"
#include "core/net/endpoint.h"
#include "player/demo/demo_motion.h"
#include "player/send/send_plan.h"

namespace rocinante {

/// Options of both kinds of information source.
struct SourceOptions {
  Endpoint to = Endpoint::standard();
  PlaybackSpeed speed;
  std::uint32_t turns = 1;              ///< how often the motion is sent; 0: endless
  std::optional<Nanoseconds> duration;  ///< in the motion's own time; empty: all of it
  std::string run;                      ///< RUN; empty: a random token
  std::size_t mtu_bytes = 1200;
  Realtime realtime = Realtime::automatic;
  bool progress = false;
};

struct CsvSourceOptions {
  std::filesystem::path csv;
  std::string device;
  std::string source;                ///< SOURCE; empty: the device's name
  std::vector<std::string> columns;  ///< joints; empty: all but the time
  /// Real time between restatements; 0: never.
  Nanoseconds restate = std::chrono::seconds(2);
  bool stamp_clock = false;  ///< TIME is the wall clock when sending, not the file's time
};

/// Sends a table of joint values on its own schedule (docs/programs/source.md). Refuses a faulty
/// table before the first datagram.
Result<PlayReport> sendCsv(const CsvSourceOptions& csv, const SourceOptions& options,
                           const SendSurroundings& surroundings);

/// Sends the demo's motion; TIME counts from the wall clock at the start.
Result<PlayReport> sendDemo(const std::vector<DemoPart>& parts, const SourceOptions& options,
                            const SendSurroundings& surroundings);

}  // namespace rocinante
