#pragma once

#include <string>

#include "recorder/diff/log_diff.h"

namespace rocinante {

/// For people: several lines, the last with its LF.
std::string diffText(const LogDiff& diff);
/// For scripts: one JSON object with its LF.
std::string diffJson(const LogDiff& diff);

}  // namespace rocinante
