#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/playback_speed.h"
#include "core/base/result.h"
#include "core/base/time.h"

namespace rocinante {

/// What can be asked of a running player (docs/programs/play.md, "Control").
struct PlayheadCommand {
  enum class Kind : std::uint8_t {
    play,
    pause,
    toggle,
    step,      ///< `count` messages on
    back,      ///< `count` messages back
    move,      ///< by `duration` of log time, also negative
    next,      ///< to the next event
    previous,  ///< to the event before
    seek,      ///< to `from`
    speed,     ///< to `speed`
    faster,    ///< to the next of the usual speeds
    slower,
    loop,  ///< [from, until), again and again
    loop_off,
    status,
    quit,
    ack,  ///< `count` messages have been dealt with (lockstep)
  };

  Kind kind = Kind::status;
  std::uint64_t count = 1;
  Nanoseconds duration{};
  LogTime from{}, until{};
  PlaybackSpeed speed;
};

/// Longer ones are refused: so many datagrams at once are no stepping any more.
inline constexpr std::uint64_t kMaxSteps = 1'000'000;
inline constexpr std::size_t kMaxCommandBytes = 256;

/// Reads one line, without its line end. Session times count from `origin`, negative ones from
/// `end`. bad_argument, with one sentence, when it is none.
Result<PlayheadCommand> parsePlayheadCommand(std::string_view line, LogTime origin, LogTime end);

}  // namespace rocinante
