#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/playback_speed.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/net/endpoint.h"
#include "player/send/send_plan.h"
#include "player/source/log_speaker.h"

namespace rocinante {

/// Options of every kind of information source.
struct SourceOptions {
  Endpoint to = Endpoint::standard();
  PlaybackSpeed speed;
  std::uint32_t turns = 1;              ///< how often the motion is sent; 0: endless
  std::optional<Nanoseconds> duration;  ///< in the motion's own time; empty: all of it
  std::string run;                      ///< RUN; empty: a random token
  std::size_t mtu_bytes = 1200;
  std::filesystem::path key;  ///< signs every datagram (docs/signing.md); empty: unsigned
  Realtime realtime = Realtime::automatic;
  bool progress = false;
};

struct CsvSourceOptions {
  std::filesystem::path csv;
  std::string device;  ///< of all columns; empty: columns name their device (readCsvMotion())
  std::string source;  ///< SOURCE; empty: the name of the first device
  std::vector<std::string> columns;  ///< empty: all but the time
  /// Real time between restatements; 0: never.
  Nanoseconds restate = std::chrono::seconds(2);
  bool stamp_clock = false;  ///< TIME is the wall clock when sending, not the file's time
};

/// Sends a table of joint values on its own schedule (docs/programs/source.md). Refuses a faulty
/// table before the first datagram.
Result<PlayReport> sendCsv(const CsvSourceOptions& csv, const SourceOptions& options,
                           const SendSurroundings& surroundings);

struct LogSourceOptions {
  std::filesystem::path log;
  LogChoice choice;
  std::optional<std::string> from;  ///< session times (core/session/session_time.h), [from, until);
  std::optional<std::string> until;  ///< empty: all
  /// Real time in which each source restates itself; 0: only at the start of each turn.
  Nanoseconds restate = std::chrono::seconds(2);
};

/// Sends a recorded session as live sources (docs/programs/source.md). bad_argument when a pattern
/// or a name matches no source of the log; not_found when there is nothing to send. Damage of the
/// log is in the report.
Result<PlayReport> sendLog(const LogSourceOptions& log, const SourceOptions& options,
                           const SendSurroundings& surroundings);

/// Sends the motion of the demo cell, a log that is installed with the programs
/// (examples/demo/motion.mcap): of the source `part`, or of all for "all". `restate` as in
/// LogSourceOptions.
Result<PlayReport> sendDemo(const std::string& part, Nanoseconds restate,
                            const SourceOptions& options, const SendSurroundings& surroundings);

/// The clock that TIME and signatures are taken from.
WallTime wallNow();

/// RUN, or else ten hexadecimal digits chosen anew at each start, so that a receiver can tell a
/// restart from late packets.
std::string runOf(const SourceOptions& options);

/// The largest datagram before it is signed, bytes.
std::size_t unsignedBytes(const SourceOptions& options);

}  // namespace rocinante
