#pragma once

#include <cstdint>
#include <map>

#include "core/log/log_types.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// States of a session kept along the way, so that going back starts near. Bounded: where there is
/// no more room those go that are the quickest made again, but for the ones used last. Pure.
class StateCache {
 public:
  struct Kept {
    SessionState state;
    /// Where the fold that led to it began: a keyframe, or the earliest place.
    LogPosition base;
    std::uint64_t messages = 0;  ///< read since then
    std::uint64_t used = 0;      ///< in calls of this cache
  };

  static constexpr std::size_t kMaxStates = 512;
  static constexpr std::uint64_t kMaxBytes = std::uint64_t{64} << 20U;

  /// How many messages should lie between two kept states: large states are dear to copy.
  static std::uint64_t interval(const SessionState& state);

  /// Keeps the state of all messages up to and with the one at `place`; may let any other go.
  void keep(LogPosition place, const SessionState& state, LogPosition base, std::uint64_t messages);

  /// The last one not behind `place`; null when there is none. Valid until the next keep().
  const std::pair<const LogPosition, Kept>* nearest(LogPosition place);

  std::size_t count() const { return kept_.size(); }
  std::uint64_t bytes() const { return bytes_; }

 private:
  void dropOne();

  std::map<LogPosition, Kept> kept_;
  std::uint64_t bytes_ = 0;
  std::uint64_t calls_ = 0;
};

}  // namespace rocinante
