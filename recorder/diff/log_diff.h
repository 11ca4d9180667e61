#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/log/log_reader.h"

namespace rocinante {

/// A message's place in a log, for a report.
struct DiffPlace {
  std::uint64_t number = 0;  ///< of the captured message in its log, from 0
  LogTime time{};
  std::string topic;
  std::string payload;  ///< its first bytes
};

/// Whether two logs hold the same captured messages in the same order, regardless of their times.
struct PayloadDiff {
  std::uint64_t same = 0;    ///< messages in both
  std::uint64_t only_a = 0;  ///< and in only one
  std::uint64_t only_b = 0;
  /// The first difference; empty on the side that has ended.
  bool differs = false;
  std::optional<DiffPlace> first_a, first_b;
};

/// Whether the messages that both hold have the same times.
struct TimeDiff {
  std::uint64_t moved = 0;
  Nanoseconds least{0}, most{0};       ///< time in b minus time in a, over all that both hold
  std::optional<DiffPlace> first_a;    ///< the first that moved
  std::optional<DiffPlace> largest_a;  ///< the one that moved furthest; the first of equals
  Nanoseconds first_shift{0}, largest_shift{0};
};

/// Whether both logs fold to the same state at every log time.
struct StateDiff {
  bool differs = false;
  bool ends_differ = false;  ///< the states at the end of both
  LogTime first{};           ///< the first moment at which the states differ
  /// Items of the states at that moment that only one log has; at most kMaxItems each.
  std::vector<std::string> only_a, only_b;
  std::uint64_t items_only_a = 0, items_only_b = 0;
};

struct LogDiff {
  static constexpr std::size_t kMaxItems = 20;

  std::string name_a, name_b;
  LogTime origin_a{}, origin_b{};
  std::uint64_t messages_a = 0, messages_b = 0;
  /// Empty when not requested.
  std::optional<PayloadDiff> payload;
  std::optional<TimeDiff> time;
  std::optional<StateDiff> state;

  bool same() const {
    return !(payload && payload->differs) && !(time && time->moved > 0) &&
           !(state && state->differs);
  }
};

enum class DiffBy { payload, time, state, all };

/// Compares the captured messages (and, by state, all folded ones) of two logs. Messages are
/// matched in order: after a difference, the nearest place within a few thousand messages where the
/// logs match again is searched for. When comparing by time only, messages that only one log holds
/// are a difference too. Memory is bounded for logs of any size.
Result<LogDiff> diffLogs(LogReader& a, LogReader& b, DiffBy by,
                         const std::function<void(double)>& progress = {});

/// Folds two logs side by side from their beginnings, and finds the first log time at which their
/// states differ.
Result<StateDiff> diffStates(LogReader& a, LogReader& b,
                             const std::function<void(LogTime)>& progress);

/// Several lines for the user, each with LF.
std::string diffText(const LogDiff& diff);
/// One JSON object for scripts, with LF.
std::string diffJson(const LogDiff& diff);

}  // namespace rocinante
