#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "core/base/time.h"

namespace rocinante {

/// The player's position, for another thread to show. Written by the sending thread.
struct PlayStatus {
  std::atomic<std::int64_t> position_ns{0};  ///< log time
  std::atomic<std::uint64_t> sent{0};
  std::atomic<double> speed{1};          ///< 0: without a schedule
  std::atomic<int> state{0};             ///< Playhead::State
  std::atomic<std::int64_t> next_ns{0};  ///< steady time of the next datagram; 0: none
};

/// The player's position for a live line, at `now`: seconds from `origin`, the speed, the state; in
/// a long silence how long it lasts.
std::string playLineText(const PlayStatus& status, LogTime origin, LogTime end, SteadyTime now);

}  // namespace rocinante
