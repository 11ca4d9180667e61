#include "recorder/contents/log_mark.h"

#include <fmt/format.h>

#include "core/base/duration_text.h"
#include "core/log/log_reader.h"
#include "core/session/marks.h"
#include "core/session/moment_name.h"
#include "core/session/timeline.h"

namespace rocinante {

Result<MarkMade> markLog(const std::filesystem::path& log, std::string_view time,
                         std::string text) {
  const Result<LogReader> reader = LogReader::open(log);
  if (!reader) return reader.error();
  const LogSummary& summary = reader->summary();
  if (summary.messages == 0) {
    return Error{ErrorKind::bad_argument, "the log has no captured message, so no moment to mark",
                 log.string()};
  }
  Result<LogTime> moment = parseSessionTime(time, summary.origin, summary.end);
  if (!moment && !isSessionTime(time)) {
    Result<Timeline> session = Timeline::open(log);
    if (!session) return session.error();
    moment = parseMoment(time, *session);
  }
  if (!moment) return moment.error();
  if (*moment < summary.start || *moment > summary.end) {
    return Error{ErrorKind::bad_argument,
                 fmt::format("the time is outside the log, which covers {} s to {} s",
                             secondsText(summary.start - summary.origin, 3),
                             secondsText(summary.end - summary.origin, 3)),
                 std::string(time)};
  }
  MarkMade made{{*moment, {}, std::move(text)}, summary.origin};
  if (Status added = addMark(log, made.mark); !added) return added.error();
  return made;
}

}  // namespace rocinante
