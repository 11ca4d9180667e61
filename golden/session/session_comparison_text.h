#pragma once

#include <string>

#include "golden/session/session_comparison.h"

namespace rocinante {

/// Text of several lines, and one JSON object.
std::string sessionText(const SessionComparison& comparison);
std::string sessionJson(const SessionComparison& comparison);

}  // namespace rocinante
