#pragma once

#include <string>

#include "recorder/spy/spy_report.h"

namespace rocinante {

/// One JSON object for scripts (docs/programs/spy.md), indented or on one line, without LF.
std::string spyJson(const SpyReport& report, bool indented);

}  // namespace rocinante
