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

/// The options that `rocinante play` was given.
struct ReplayOptions {
  PlaybackSpeed speed;
  std::vector<RouteMap> maps;         ///< the first that matches a topic is used
  std::optional<Nanoseconds> within;  ///< largest time error allowed; empty: any
};

/// The replayed messages of one source to one endpoint.
struct ReplaySource {
  std::string source;  ///< empty: datagrams without a SOURCE
  std::string to;      ///< PORT or GROUP:PORT of the map they match; empty: no map
  std::uint64_t messages_a = 0, messages_b = 0;
  std::uint64_t same = 0;  ///< byte for byte, in order
  std::uint64_t missing = 0;
  std::uint64_t extra = 0;
  std::uint64_t out_of_order = 0;  ///< in both, at another place within the source
  /// Time errors of the matching messages, microseconds rounded up.
  std::uint64_t error_p50_us = 0, error_p99_us = 0, error_max_us = 0;
  /// The first difference; empty where that side has ended.
  bool differs = false;
  std::optional<DiffPlace> first_a, first_b;
};

/// Whether log b recorded a replay of log a.
struct ReplayDiff {
  std::string name_a, name_b;
  LogTime origin_a{}, origin_b{};
  std::uint64_t messages_a = 0, messages_b = 0;
  /// SHA-256 of the concatenated payloads, as in the player's report and `log info`.
  std::string stream_a, stream_b;
  std::vector<ReplaySource> sources;  ///< by name
  double speed = 1;
  std::optional<double> measured_speed;  ///< empty when fewer than two messages are in both
  std::uint64_t lost_b = 0;              ///< datagrams that the recorder of b lost
  std::optional<Nanoseconds> within;

  bool same() const;
  /// True if the measured speed is far from the one given.
  bool otherSpeed() const;
};

/// Compares the captured messages of a log with those of a recording of its replay, source by
/// source. Topics are not compared: they hold the port, which differs in the replay. Times are
/// compared from the first message that both hold: one that is `t` later in a is due `t / speed`
/// later in b. Reads both logs once for each source and twice more; memory is bounded except for
/// the digests of messages that only one has, at most a million.
Result<ReplayDiff> diffReplay(LogReader& a, LogReader& b, const ReplayOptions& options,
                              const std::function<void(double)>& progress = {});

/// Several lines for the user, each with LF.
std::string replayText(const ReplayDiff& diff);
/// One JSON object for scripts, with LF.
std::string replayJson(const ReplayDiff& diff);

}  // namespace rocinante
