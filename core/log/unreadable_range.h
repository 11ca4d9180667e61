#pragma once

#include <cstddef>
#include <limits>

#include "core/log/log_types.h"

namespace rocinante {

/// Where in a log's order the messages lie that damage cost: not before `first`, not behind `last`.
/// As narrow as the file tells: of a chunk that cannot be read, or only in part, the times that its
/// index gives; of bytes that are no record, what lies between the chunks before and behind them.
/// Where the chunks of a file are not in order of time the latter can be anywhere. Unbounded where
/// nothing stands before or behind.
struct UnreadableRange {
  LogPosition first{LogTime::min(), 0};
  LogPosition last{LogTime::max(), std::numeric_limits<std::uint64_t>::max()};
  std::size_t damage = 0;  ///< its place in LogReader::damage()
};

}  // namespace rocinante
