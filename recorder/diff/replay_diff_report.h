#pragma once

#include <string>

#include "recorder/diff/replay_diff.h"

namespace rocinante {

/// For people: several lines, the last with its LF.
std::string replayText(const ReplayDiff& diff);
/// For scripts: one JSON object with its LF.
std::string replayJson(const ReplayDiff& diff);

}  // namespace rocinante
