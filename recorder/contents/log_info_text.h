#pragma once

#include <string>

#include "recorder/contents/log_info.h"

namespace rocinante {

/// Several lines for the user, each with LF.
std::string logInfoText(const LogInfo& info);

}  // namespace rocinante
