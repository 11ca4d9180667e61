#pragma once

#include <cstddef>
#include <string>

#include "core/report/time_histogram.h"

namespace rocinante {

/// When in a session something happened, as `width` characters for its whole duration: a space for
/// none, higher blocks (or darker ASCII) for more. Empty without hits or duration.
std::string timeStrip(const TimeHistogram& when, LogTime origin, Nanoseconds duration,
                      std::size_t width, bool unicode);

}  // namespace rocinante
