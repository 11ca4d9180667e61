#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "core/log/log_types.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// States of a session kept while folding, so that moving back starts nearby. Bounded: when there
/// is no more room, the states that are the quickest to make again are dropped, except recently
/// used ones. Pure.
class StateCache {
 public:
  struct Kept {
    SessionState state;
    /// The start of the fold that led to it: a keyframe, or the earliest position.
    LogPosition base;
    std::uint64_t messages = 0;  ///< read since then
    std::uint64_t used = 0;      ///< in calls of this cache
  };

  static constexpr std::size_t kMaxStates = 512;
  static constexpr std::uint64_t kMaxBytes = std::uint64_t{64} << 20U;

  /// How many messages should be between two kept states: large states are expensive to copy.
  static std::uint64_t interval(const SessionState& state);

  /// Keeps the state after the message at `place`; may drop any other.
  void keep(LogPosition place, const SessionState& state, LogPosition base, std::uint64_t messages);

  /// The last state not behind `place`; null when there is none. Valid until the next keep().
  const std::pair<const LogPosition, Kept>* nearest(LogPosition place);

  /// The position of the last state kept.
  std::optional<LogPosition> last() const {
    if (kept_.empty()) return std::nullopt;
    return kept_.rbegin()->first;
  }

  std::size_t count() const { return kept_.size(); }
  std::uint64_t bytes() const { return bytes_; }

 private:
  void dropOne();

  std::map<LogPosition, Kept> kept_;
  std::uint64_t bytes_ = 0;
  std::uint64_t calls_ = 0;
};

}  // namespace rocinante
