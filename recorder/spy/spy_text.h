#pragma once

#include <cstddef>
#include <string>

#include "recorder/spy/spy_report.h"

namespace rocinante {

/// Tables for the user, each with at most `rows` lines (0: all), of at most `columns` characters
/// (0: any, as in a pipe). With both they fit a screen; on a terminal the reasons come first.
std::string spyText(const SpyReport& report, std::size_t rows, std::size_t columns);

}  // namespace rocinante
