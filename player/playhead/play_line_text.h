#pragma once

#include <string>

#include "core/base/time.h"
#include "player/playhead/play_status.h"

namespace rocinante {

/// The player's position for a live line, at `now`: seconds from `origin`, the speed, the state; in
/// a long silence how long it lasts.
std::string playLineText(const PlayStatus& status, LogTime origin, LogTime end, SteadyTime now);

}  // namespace rocinante
