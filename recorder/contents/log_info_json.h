#pragma once

#include <string>

#include "recorder/contents/log_info.h"

namespace rocinante {

/// For scripts: one JSON object, indented or on one line, with its LF.
std::string logInfoJson(const LogInfo& info, bool indented);

}  // namespace rocinante
