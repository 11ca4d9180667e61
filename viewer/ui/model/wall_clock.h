#pragma once

#include <string>

#include "core/base/time.h"

namespace rocinante {

/// Whether a session with that origin has times of a calendar: from the year 2000 on. Others, such
/// as simulated ones, begin near zero.
bool hasWallClock(LogTime origin);

/// "05:12:07.930": the time of day in UTC, to the millisecond.
std::string clockText(LogTime moment);

/// "2026-11-21 05:12:07.930 UTC".
std::string calendarText(LogTime moment);

/// The time of day in UTC as the label of a tick, as exact as the step needs: "11-21" by days,
/// "05:12" by minutes, "05:12:07", and below a second "12:07.25".
std::string clockLabel(LogTime moment, Nanoseconds step);

}  // namespace rocinante
