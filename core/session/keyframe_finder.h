#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/log/log_reader.h"
#include "core/packet/session_state.h"
#include "core/session/keyframe.h"

namespace rocinante {

/// Finds the keyframes of one log that can be started from, and says which cannot
/// (docs/log-format.md, "Keyframes"). Remembers what it found: asking near a moment that was asked
/// for before does not look into the log again.
class KeyframeFinder {
 public:
  /// The reader is borrowed: it must outlive the finder, and what it lent before any call here is
  /// no longer valid afterwards.
  explicit KeyframeFinder(LogReader& reader);

  /// True for a message that may be a keyframe; usable() then says whether it is one.
  bool isOne(const LogMessage& message) const {
    return channel_ && message.channel->id == *channel_;
  }
  /// The state that it tells; empty when it does not count.
  std::optional<SessionState> usable(const LogMessage& message);

  struct Found {
    LogPosition place;
    SessionState state;
  };
  /// The last usable keyframe at or before `moment`, when it lies behind `known` (a place from
  /// which one can start as well); empty when there is none.
  Result<std::optional<Found>> lastBefore(LogTime moment, const std::optional<LogPosition>& known);

  const std::vector<KeyframeFault>& faults() const { return faults_; }

 private:
  void refuse(const LogMessage& message, std::string cause);
  void remember(std::optional<LogPosition> place, LogTime moment);

  LogReader& reader_;
  KeyframeReader keyframes_;
  std::optional<ChannelId> channel_;

  /// From the time of each keyframe found, up to when it is known to be the last; the earliest time
  /// stands for none.
  struct Known {
    std::optional<LogPosition> place;
    LogTime until = LogTime::min();
  };
  std::map<LogTime, Known> known_;
  std::set<LogPosition> refused_;
  std::vector<KeyframeFault> faults_;
};

}  // namespace rocinante
