#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/log/log_types.h"
#include "core/log/message_span.h"
#include "core/log/unreadable_range.h"

namespace rocinante {

/// Of `damage` in a file of so many bytes with these spans; empty when it cost no message. What a
/// killed recorder leaves, or a file that was cut, has lost what came after the last message that
/// can be read, and nothing before it. Pure.
std::optional<UnreadableRange> unreadableRange(const DamageSpan& damage,
                                               const std::vector<MessageSpan>& spans, bool in_order,
                                               std::uint64_t file_bytes);

/// True when each span begins where those before it in the file have ended, or later.
bool areInOrder(const std::vector<MessageSpan>& spans);

}  // namespace rocinante
