#include "player/logs/played_span.h"

#include <algorithm>

#include "core/session/session_time.h"

namespace rocinante {

Result<PlayedSpan> playedSpan(const MultiLogReader& logs, const std::optional<std::string>& from,
                              const std::optional<std::string>& until) {
  PlayedSpan span{logs.start(), logs.end() + Nanoseconds(1)};
  if (from) {
    const auto moment = parseSessionTime(*from, logs.origin(), logs.end());
    if (!moment) return moment.error();
    // Before the first message there is nothing to wait for.
    span.from = std::max(*moment, logs.start());
  }
  if (until) {
    const auto moment = parseSessionTime(*until, logs.origin(), logs.end());
    if (!moment) return moment.error();
    span.until = *moment;
  }
  return span;
}

}  // namespace rocinante
