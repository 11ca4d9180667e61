#include "core/session/session_time.h"

#include "core/base/duration_text.h"

namespace rocinante {
namespace {

/// "2026-02-03..." is a date: no duration has a hyphen after a digit.
bool looksLikeADate(std::string_view text) {
  return text.size() > 4 && text.find('-', 1) != std::string_view::npos;
}

}  // namespace

Result<LogTime> parseSessionTime(std::string_view text, LogTime origin, LogTime end) {
  if (looksLikeADate(text)) {
    Result<WallTime> wall = parseRfc3339(text);
    if (!wall) return wall.error();
    return LogTime(wall->time_since_epoch());
  }
  Result<Nanoseconds> duration = parseDuration(text);
  if (!duration) {
    return Error{ErrorKind::bad_argument,
                 "a time is 12.5s or 1m02.5s from the session's origin, -1s from its end, or "
                 "2026-02-03T04:05:06Z",
                 std::string(text)};
  }
  const LogTime base = text.starts_with('-') ? end : origin;
  std::int64_t moment = 0;
  if (__builtin_add_overflow(base.time_since_epoch().count(), duration->count(), &moment)) {
    return Error{ErrorKind::bad_argument, "the time is beyond what a log can hold",
                 std::string(text)};
  }
  return LogTime(Nanoseconds(moment));
}

}  // namespace rocinante
