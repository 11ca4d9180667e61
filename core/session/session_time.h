#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/base/time.h"

namespace rocinante {

/// Parses a user's time in a session: "12.5", "12.5s", "1m02.5s", "250ms" from the origin, "-1s"
/// from the end, or RFC 3339 "2026-02-03T04:05:06.789Z". Exact to the nanosecond.
Result<LogTime> parseSessionTime(std::string_view text, LogTime origin, LogTime end);

}  // namespace rocinante
