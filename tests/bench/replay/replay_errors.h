#pragma once

#include <cstdint>
#include <vector>

#include "core/base/playback_speed.h"
#include "core/base/time.h"

namespace rocinante::bench {

/// How far the arrivals of a replay lie from its schedule, in microseconds.
struct ReplayErrors {
  std::size_t arrived = 0;
  double p50_us = 0, p99_us = 0, max_us = 0;  ///< of the amount, early or late
  double drift_us = 0;  ///< median error of the last 100 less that of the first 100
};

/// `due` in log time, `arrived_ns` on any clock, 0 where nothing came. A replay may begin when it
/// likes and may not be early at first: the schedule is laid through the earliest of the first 100.
ReplayErrors replayErrors(const std::vector<Nanoseconds>& due,
                          const std::vector<std::int64_t>& arrived_ns, const PlaybackSpeed& speed);

}  // namespace rocinante::bench
