#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>

#include "core/session/state_damage.h"

namespace rocinante {

/// Datagrams of each source in the last second of a log: those in (time - 1 s, time]. A function of
/// log and time only; moving forward reads only the messages in between. Not thread-safe.
class SourceRates {
 public:
  explicit SourceRates(LogReader reader) : reader_(std::move(reader)) {}

  /// Datagrams by source, or by topic when a datagram names no source; includes every source of the
  /// log. Datagrams hidden by damage of the log are not counted; the damage is added to `damage`.
  Result<std::map<std::string, std::uint64_t>> at(LogTime time, StateDamage& damage);

 private:
  struct Counted {
    LogTime time;
    const LogChannel* channel;
  };
  Status readOn(LogTime time);

  LogReader reader_;
  std::deque<Counted> window_;
  std::optional<LogTime> reached_;  ///< messages up to here were read
  std::optional<Counted> next_;     ///< the first one after it
  bool at_end_ = false;
};

}  // namespace rocinante
