#pragma once

#include <cstddef>
#include <string>

#include "core/check/rules/time_histogram.h"

namespace rocinante {

/// Where in a session something happened, `width` characters for its whole duration: a space where
/// nothing did, higher blocks (or darker ASCII) where more did. Empty without hits or duration.
std::string timeStrip(const TimeHistogram& when, LogTime origin, Nanoseconds duration,
                      std::size_t width, bool unicode);

}  // namespace rocinante
