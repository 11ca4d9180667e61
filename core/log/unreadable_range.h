#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "core/log/log_types.h"
#include "core/log/message_span.h"

namespace rocinante {

/// Where in a log's order the messages lie that damage cost: not before `first`, not behind `last`.
/// As narrow as the file tells: of a chunk that cannot be read, or only in part, the times that its
/// index gives; of bytes that are no record, what lies between the chunks before and behind them.
/// Where the chunks of a file are not in order of time the latter can be anywhere. Unbounded where
/// nothing stands before or behind.
struct UnreadableRange {
  LogPlace first{LogTime::min(), 0};
  LogPlace last{LogTime::max(), std::numeric_limits<std::uint64_t>::max()};
  std::size_t damage = 0;  ///< its place in LogReader::damage()
};

/// Of `damage` in a file of so many bytes with these spans; empty when it cost no message. What a
/// killed recorder leaves, or a file that was cut, has lost what came after the last message that
/// can be read, and nothing before it. Pure.
std::optional<UnreadableRange> unreadableRange(const DamageSpan& damage,
                                               const std::vector<MessageSpan>& spans, bool in_order,
                                               std::uint64_t file_bytes);

/// True when each span begins where those before it in the file have ended, or later.
bool areInOrder(const std::vector<MessageSpan>& spans);

}  // namespace rocinante
