#pragma once

#include "core/log/span_cache.h"

namespace rocinante {

/// The log times of the first and the last captured message.
struct CapturedRange {
  LogTime start = LogTime::max();  ///< behind `end` while there is none
  LogTime end{};
};

/// Widens `range` by the captured messages of the spans [from, until): not at all when none of them
/// can be read and no index gives their times. Without `others`, messages that are not captured,
/// the spans' own times suffice; with them, the spans at either end are read until no other can
/// hold an earlier or later message.
void widen(CapturedRange& range, SpanCache& cache, std::size_t from, std::size_t until,
           bool others);

}  // namespace rocinante
