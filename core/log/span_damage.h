#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/log/log_types.h"
#include "core/log/message_span.h"
#include "core/log/unreadable_range.h"

namespace rocinante {

/// The range in which `damage` cost messages, for a file of this size with these spans; empty when
/// it cost none. A killed recorder or a cut file loses what came after the last readable message,
/// and nothing before it. Pure.
std::optional<UnreadableRange> unreadableRange(const DamageSpan& damage,
                                               const std::vector<MessageSpan>& spans, bool in_order,
                                               std::uint64_t file_bytes);

/// True when each span begins at or after the end of all those before it in the file.
bool areInOrder(const std::vector<MessageSpan>& spans);

}  // namespace rocinante
