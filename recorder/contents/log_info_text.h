#pragma once

#include <string>

#include "recorder/contents/log_info.h"

namespace rocinante {

/// For people: several lines, the last with its LF.
std::string logInfoText(const LogInfo& info);

}  // namespace rocinante
