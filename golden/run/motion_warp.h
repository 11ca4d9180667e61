#pragma once

#include "golden/run/session_track.h"
#include "golden/run/time_map.h"

namespace rocinante {

/// Of the bends in time; of very long sessions a multiple of it.
inline constexpr Nanoseconds kWarpStep = std::chrono::milliseconds(20);

/// `map` bent so that the motion of `other` fits that of `first` best: at each time by at most
/// `most` to either side, never backwards, at most twice as fast, and not at all at the map's knots
/// when they are events (`keeps_knots`; otherwise not at the start). All joints bend together, so
/// one that alone is late stays late.
TimeMap warpedMap(const SessionTrack& first, const SessionTrack& other, const TimeMap& map,
                  bool keeps_knots, Nanoseconds most);

}  // namespace rocinante
