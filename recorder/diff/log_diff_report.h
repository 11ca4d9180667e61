#pragma once

#include <string>

#include "recorder/diff/log_diff.h"

namespace rocinante {

/// Several lines for the user, each with LF.
std::string diffText(const LogDiff& diff);
/// One JSON object for scripts, with LF.
std::string diffJson(const LogDiff& diff);

}  // namespace rocinante
