#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/session/event_alignment.h"
#include "core/session/timeline.h"

namespace rocinante {

/// Limits within which two recordings of one scenario count as the same.
struct SessionLimits {
  double radians = 1e-3;
  double metres = 1e-3;
  /// Packets arrive slightly earlier or later: a value counts as equal when the other session has a
  /// matching one within this time.
  Nanoseconds slack{std::chrono::milliseconds(50)};
  Nanoseconds step{std::chrono::milliseconds(20)};  ///< sampling period of both
};

/// A difference: of a joint value, a part of a base pose, or a fact.
struct Deviation {
  std::string item;                  ///< "arm/elbow", "canister.x", "show arm/link3"
  std::string unit;                  ///< "rad", "m", "" for parts of a quaternion and facts
  std::optional<double> largest;     ///< empty for facts
  LogTime largest_at{}, first_at{};  ///< in a's time; `first_at`: first beyond its limit
};

struct SessionDeviation {
  std::size_t items = 0;    ///< compared items
  std::size_t samples = 0;  ///< moments
  Nanoseconds step{0};      ///< period of samples; longer than requested for very long sessions
  LogTime from{}, until{};  ///< the range covered by both, in a's time
  std::vector<Deviation> beyond;            ///< those beyond their limit, by first_at
  std::optional<Deviation> largest_within;  ///< of the others, relative to the limit
};

/// Compares the two as functions of aligned time. not_found when they have no time in common.
/// Damage of a log that affects their states is added to `damage`.
Result<SessionDeviation> compareSessions(const Cell& cell, Timeline& a, Timeline& b,
                                         const EventAlignment& alignment,
                                         const SessionLimits& limits, StateDamage& damage);

/// The one of `candidates`, times of b, at which b's state is most like that of a at `in_a`: fewest
/// different facts, then smallest deviation relative to its limit, then nearest to `in_b`.
Result<LogTime> nearestMoment(const Cell& cell, Timeline& a, LogTime in_a, Timeline& b,
                              LogTime in_b, const std::vector<LogTime>& candidates,
                              const SessionLimits& limits);

}  // namespace rocinante
