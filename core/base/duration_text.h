#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/base/time.h"

namespace rocinante {

/// For sentences about long times: "53.9 years", "3.4 days", "2.0 hours", "75 s".
std::string roughDuration(Nanoseconds duration);

/// "12.5" or "12.5s" (seconds), "250ms", "50us", "10ns", "1m02.5s", "1h30m": exact, to the
/// nanosecond; a finer digit is bad_argument. A leading minus is accepted. No exponent.
Result<Nanoseconds> parseDuration(std::string_view text);

/// RFC 3339 with a zone ("Z" or "+01:00"), up to nine decimals.
Result<WallTime> parseRfc3339(std::string_view text);

/// Seconds with as many decimals as needed and at least `decimals`: "12.5", "0.000".
std::string secondsText(Nanoseconds duration, int decimals = 0);

/// "2026-02-03T04:05:06.789012345Z".
std::string rfc3339Text(WallTime time);

}  // namespace rocinante
