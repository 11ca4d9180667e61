#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/playback_speed.h"
#include "core/base/result.h"
#include "core/base/time.h"

namespace rocinante {

/// A command to a running player (docs/programs/play.md, "Control").
struct PlayheadCommand {
  enum class Kind : std::uint8_t {
    play,
    pause,
    toggle,
    step,      ///< `count` messages forwards
    back,      ///< `count` messages back
    move,      ///< by `duration` of log time, may be negative
    next,      ///< to the next event
    previous,  ///< to the previous event
    seek,      ///< to `from`
    speed,     ///< to `speed`
    faster,    ///< to the next of the usual speeds
    slower,
    loop,  ///< repeat [from, until)
    loop_off,
    status,
    quit,
    ack,  ///< message `count` has been processed (lockstep)
  };

  Kind kind = Kind::status;
  std::uint64_t count = 1;
  Nanoseconds duration{};
  LogTime from{}, until{};
  PlaybackSpeed speed;
};

/// Most messages of one step.
inline constexpr std::uint64_t kMaxSteps = 1'000'000;
inline constexpr std::size_t kMaxCommandBytes = 256;

/// Parses one line, without its line end. Session times count from `origin`, negative ones from
/// `end`. bad_argument, with one sentence, for an invalid command.
Result<PlayheadCommand> parsePlayheadCommand(std::string_view line, LogTime origin, LogTime end);

}  // namespace rocinante
