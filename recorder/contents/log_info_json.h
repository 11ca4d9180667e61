#pragma once

#include <string>

#include "recorder/contents/log_info.h"

namespace rocinante {

/// One JSON object for scripts, indented or on one line, with LF.
std::string logInfoJson(const LogInfo& info, bool indented);

}  // namespace rocinante
