#pragma once

#include "core/log/span_cache.h"

namespace rocinante {

/// The log times of the first and the last captured message.
struct CapturedRange {
  LogTime start{};
  LogTime end{};
};

/// Of a log that has captured messages; both are zero when none of them can be read and no index
/// gives their times. Without `others`, messages that are not captured, the spans' own times
/// suffice; with them, the spans at either end are read until no other can hold an earlier or later
/// message.
CapturedRange capturedRange(SpanCache& cache, bool others);

}  // namespace rocinante
