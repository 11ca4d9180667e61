#pragma once

#include <cstddef>
#include <limits>

#include "core/log/log_types.h"

namespace rocinante {

/// The range in a log's order of messages lost to damage: not before `first`, not behind `last`. As
/// narrow as the file allows: for a chunk that cannot be read, or only in part, the times from its
/// index; for bytes that are not a record, the range between the chunks before and behind them. If
/// the chunks of a file are not in time order, such messages can be anywhere. Unbounded on a side
/// without a chunk.
struct UnreadableRange {
  LogPosition first{LogTime::min(), 0};
  LogPosition last{LogTime::max(), std::numeric_limits<std::uint64_t>::max()};
  std::size_t damage = 0;  ///< its index in LogReader::damage()
};

}  // namespace rocinante
