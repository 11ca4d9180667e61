#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/log/log_reader.h"

namespace rocinante {

/// Where a message stands, for a report.
struct DiffPlace {
  std::uint64_t number = 0;  ///< of the captured message in its log, from 0
  LogTime time{};
  std::string topic;
  std::string payload;  ///< its beginning
};

/// Whether two logs hold the same captured messages, in the same order, whatever their times.
struct PayloadDiff {
  std::uint64_t same = 0;    ///< messages of both
  std::uint64_t only_a = 0;  ///< and of one alone
  std::uint64_t only_b = 0;
  /// The first place where they part; empty on the side that has ended.
  bool differs = false;
  std::optional<DiffPlace> first_a, first_b;
};

/// Of the messages that both hold: whether their times are the same.
struct TimeDiff {
  std::uint64_t moved = 0;
  Nanoseconds least{0}, most{0};       ///< time in b minus time in a, over all that both hold
  std::optional<DiffPlace> first_a;    ///< the first that moved
  std::optional<DiffPlace> largest_a;  ///< that which moved furthest, first of equals
  Nanoseconds first_shift{0}, largest_shift{0};
};

/// Whether the fold of one is that of the other at every log time.
struct StateDiff {
  bool differs = false;
  bool ends_differ = false;  ///< the states at the end of both
  LogTime first{};           ///< the first moment at which they are not the same
  /// The items of the states at that moment that only one has; each at most kMaxItems.
  std::vector<std::string> only_a, only_b;
  std::uint64_t items_only_a = 0, items_only_b = 0;
};

struct LogDiff {
  static constexpr std::size_t kMaxItems = 20;

  std::string name_a, name_b;
  LogTime origin_a{}, origin_b{};
  std::uint64_t messages_a = 0, messages_b = 0;
  /// Empty where it was not asked for.
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
/// matched in order: where the logs part, the nearest place within a few thousand messages where
/// they go on together is looked for. By time alone, messages that only one holds are a difference
/// too. Memory is bounded whatever the logs' size.
Result<LogDiff> diffLogs(LogReader& a, LogReader& b, DiffBy by,
                         const std::function<void(double)>& progress = {});

}  // namespace rocinante
