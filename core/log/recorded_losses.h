#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/log/span_cache.h"

namespace rocinante {

/// Reads the losses that the log's own channels tell, oldest first. `message_counts` is by channel.
/// A message that is none is listed as damage of the cache's log.
std::vector<LossSpan> recordedLosses(SpanCache& cache,
                                     const std::map<ChannelId, std::uint64_t>& message_counts);

}  // namespace rocinante
