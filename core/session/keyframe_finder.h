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

/// Finds the usable keyframes of one log, and reports the unusable ones (docs/log-format.md,
/// "Keyframes"). Caches results: a query near an earlier one does not read the log again.
class KeyframeFinder {
 public:
  /// The reader is borrowed: it must outlive the finder, and anything borrowed from it is invalid
  /// after a call here.
  explicit KeyframeFinder(LogReader& reader);

  /// True for a message that may be a keyframe; usable() then decides.
  bool isOne(const LogMessage& message) const {
    return channel_ && message.channel->id == *channel_;
  }
  /// Its state; empty when it is not usable.
  std::optional<SessionState> usable(const LogMessage& message);

  /// The reader has been refreshed: later keyframes may be found.
  void logGrew();

  struct Found {
    LogPosition place;
    SessionState state;
  };
  /// The last usable keyframe at or before `moment` that is behind `known` (a position that is as
  /// good a start); empty when there is none.
  Result<std::optional<Found>> lastBefore(LogTime moment, const std::optional<LogPosition>& known);

  const std::vector<KeyframeFault>& faults() const { return faults_; }

 private:
  void findChannel();
  void refuse(const LogMessage& message, std::string cause);
  void remember(std::optional<LogPosition> place, LogTime moment);

  LogReader& reader_;
  KeyframeReader keyframes_;
  std::optional<ChannelId> channel_;
  bool several_reported_ = false;

  /// From the time of each keyframe found: until when it is known to be the last. The earliest time
  /// means that there is none.
  struct Known {
    std::optional<LogPosition> place;
    LogTime until = LogTime::min();
  };
  std::map<LogTime, Known> known_;
  std::set<LogPosition> refused_;
  std::vector<KeyframeFault> faults_;
};

}  // namespace rocinante
