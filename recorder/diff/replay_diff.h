#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/playback_speed.h"
#include "core/base/result.h"
#include "core/log/log_reader.h"
#include "core/net/route_map.h"
#include "recorder/diff/log_diff.h"

namespace rocinante {

/// How the replay was played: what `rocinante play` was given.
struct ReplayOptions {
  PlaybackSpeed speed;
  std::vector<RouteMap> maps;         ///< the first that matches a topic counts
  std::optional<Nanoseconds> within;  ///< no message may be further off than this
};

/// What became of the messages of one source that went to one place.
struct ReplaySource {
  std::string source;  ///< empty: of datagrams that name none
  std::string to;      ///< PORT or GROUP:PORT of the map that they go by; empty: of none
  std::uint64_t messages_a = 0, messages_b = 0;
  std::uint64_t same = 0;  ///< byte for byte, in order
  std::uint64_t missing = 0;
  std::uint64_t extra = 0;
  std::uint64_t out_of_order = 0;  ///< in both, elsewhere among those of the source
  /// How far from their moments those that are the same came, microseconds rounded up.
  std::uint64_t error_p50_us = 0, error_p99_us = 0, error_max_us = 0;
  /// Where the two part for the first time; empty where that side has ended.
  bool differs = false;
  std::optional<DiffPlace> first_a, first_b;
};

/// Whether log b is a recording of log a played.
struct ReplayDiff {
  std::string name_a, name_b;
  LogTime origin_a{}, origin_b{};
  std::uint64_t messages_a = 0, messages_b = 0;
  /// SHA-256 of the payloads one after another, as the player's report and `log info` have it.
  std::string stream_a, stream_b;
  std::vector<ReplaySource> sources;  ///< by name
  double speed = 1;
  std::optional<double> measured_speed;  ///< empty when fewer than two messages are in both
  std::uint64_t lost_b = 0;              ///< datagrams that the recorder of b says it lost
  std::optional<Nanoseconds> within;

  bool same() const;
  /// Far from the speed that was given.
  bool otherSpeed() const;
};

/// Compares the captured messages of a log with those of a recording of its replay, source by
/// source. Topics are not compared: they hold the port, and the replay's is another. Times are
/// compared from the first message that both hold: one that lies `t` behind it in a is due
/// `t / speed` behind it in b. Reads both logs once for each source and twice more; memory is
/// bounded but for the digests of messages that only one has, of which it keeps a million.
Result<ReplayDiff> diffReplay(LogReader& a, LogReader& b, const ReplayOptions& options,
                              const std::function<void(double)>& progress = {});

}  // namespace rocinante
