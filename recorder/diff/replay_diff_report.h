#pragma once

#include <string>

#include "recorder/diff/replay_diff.h"

namespace rocinante {

/// Several lines for the user, each with LF.
std::string replayText(const ReplayDiff& diff);
/// One JSON object for scripts, with LF.
std::string replayJson(const ReplayDiff& diff);

}  // namespace rocinante
