#pragma once

#include <string>

#include "recorder/spy/spy_report.h"

namespace rocinante {

/// For scripts: one JSON object (docs/programs/spy.md), indented or on one line, without LF.
std::string spyJson(const SpyReport& report, bool indented);

}  // namespace rocinante
