#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>

#include "core/session/state_damage.h"

namespace rocinante {

/// Datagrams of each source in the last second of a log: those in (time - 1 s, time]. A function of
/// log and time alone; going forwards costs what lies between. One thread.
class SourceRates {
 public:
  explicit SourceRates(LogReader reader) : reader_(std::move(reader)) {}

  /// By source, or by topic where a datagram names none; every one that the log has.
  /// Those that damage of the log hides are not counted: it is added to `damage`.
  Result<std::map<std::string, std::uint64_t>> at(LogTime time, StateDamage& damage);

 private:
  struct Counted {
    LogTime time;
    const LogChannel* channel;
  };
  Status readOn(LogTime time);

  LogReader reader_;
  std::deque<Counted> window_;
  std::optional<LogTime> reached_;  ///< all up to here was read
  std::optional<Counted> next_;     ///< the first behind it
  bool at_end_ = false;
};

}  // namespace rocinante
