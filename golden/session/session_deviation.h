#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/session/timeline.h"
#include "golden/session/event_alignment.h"

namespace rocinante {

/// How two recordings of one scenario may differ and still be the same.
struct SessionLimits {
  double radians = 1e-3;
  double metres = 1e-3;
  /// Packets come a little earlier or later: a value counts as equal when the other session has one
  /// like it within this time.
  Nanoseconds slack{std::chrono::milliseconds(50)};
  Nanoseconds step{std::chrono::milliseconds(20)};  ///< how often both are looked at
};

/// One joint value, part of a base pose, or thing that is or is not so, that differs.
struct Deviation {
  std::string item;  ///< "arm/elbow", "canister.x", "show arm/link3"
  std::string unit;  ///< "rad", "m", "" for parts of a quaternion and what has no measure
  std::optional<double> largest;     ///< empty for what has no measure
  LogTime largest_at{}, first_at{};  ///< in a's time; `first_at`: beyond its limit
};

struct SessionDeviation {
  std::size_t items = 0;    ///< that were compared
  std::size_t samples = 0;  ///< moments
  Nanoseconds step{0};      ///< between two of them: more than asked for in a very long session
  LogTime from{}, until{};  ///< what both cover, in a's time
  std::vector<Deviation> beyond;            ///< those beyond their limit, the first to part first
  std::optional<Deviation> largest_within;  ///< of the others, relative to its limit
};

/// Compares the two as functions of aligned time. not_found when they have no time in common. What
/// their states lack, because a log is damaged, is added to `damage`.
Result<SessionDeviation> compareSessions(const Cell& cell, Timeline& a, Timeline& b,
                                         const EventAlignment& alignment,
                                         const SessionLimits& limits, StateDamage& damage);

/// Which of `candidates`, times of b, finds b in the state most like that of a at `in_a`: the
/// fewest facts that differ, then the smallest deviation in parts of its limit, then the nearest to
/// `in_b`.
Result<LogTime> nearestMoment(const Cell& cell, Timeline& a, LogTime in_a, Timeline& b,
                              LogTime in_b, const std::vector<LogTime>& candidates,
                              const SessionLimits& limits);

}  // namespace rocinante
