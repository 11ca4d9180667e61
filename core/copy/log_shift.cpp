#include <fmt/format.h>

#include <algorithm>

#include "core/base/duration_text.h"
#include "core/copy/log_edits.h"

namespace rocinante {
namespace {

/// The earliest and the latest time of anything in the log.
struct TimeBounds {
  LogTime first = LogTime::max();
  LogTime last{};
  void add(LogTime time) {
    first = std::min(first, time);
    last = std::max(last, time);
  }
};

Result<TimeBounds> boundsOf(OpenedLog& opened) {
  LogReader& reader = opened.reader;
  TimeBounds bounds;
  bounds.add(reader.summary().origin);
  bounds.add(reader.summary().end);
  for (const LossSpan& loss : reader.losses()) {
    bounds.add(loss.from);
    bounds.add(loss.until);
  }
  for (const Event& mark : opened.options.marks) bounds.add(mark.time);
  if (Status there = reader.rewind(); !there) return there.error();
  const Result<std::optional<LogMessage>> first = reader.next();
  if (!first) return first.error();
  if (*first) bounds.add((*first)->log_time);
  return bounds;
}

Result<Nanoseconds> distanceOf(const ShiftOptions& shift, const LogSummary& summary) {
  if (!shift.by.empty()) {
    const std::string_view text = shift.by;
    return parseDuration(text.starts_with('+') ? text.substr(1) : text);
  }
  const Result<WallTime> to = parseRfc3339(shift.to);
  if (!to) return to.error();
  return to->time_since_epoch() - summary.origin.time_since_epoch();
}

}  // namespace

Result<CopyReport> shiftLog(const std::filesystem::path& log, const ShiftOptions& shift,
                            const MakeOptions& make) {
  if (Status free = checkOutput(make.output, make.overwrite, {{log}}); !free) return free.error();
  Result<OpenedLog> opened = openForCopy(log);
  if (!opened) return opened.error();
  const Result<Nanoseconds> distance = distanceOf(shift, opened->reader.summary());
  if (!distance) return distance.error();
  const Result<TimeBounds> bounds = boundsOf(*opened);
  if (!bounds) return bounds.error();
  std::int64_t moved = 0;
  const std::int64_t by = distance->count();
  if (__builtin_add_overflow(bounds->first.time_since_epoch().count(), by, &moved) || moved < 0 ||
      __builtin_add_overflow(bounds->last.time_since_epoch().count(), by, &moved)) {
    return Error{ErrorKind::bad_argument,
                 "the log would begin before 1970 or end after 2262, which a log cannot store",
                 shift.by.empty() ? shift.to : shift.by};
  }
  const Result<std::string> session_id = sessionIdOf(opened->reader);
  if (!session_id) return session_id.error();
  opened->options.shift = *distance;
  opened->options.shift_publish = shift.publish;
  Result<CopySource> source =
      CopySource::of(std::move(opened->reader), std::move(opened->options), std::nullopt, {});
  if (!source) return source.error();
  std::vector<CopySource> sources;
  sources.push_back(std::move(*source));
  return makeLog(sources, make, {make.log, make.keyframes, *session_id, sources.front().origin()},
                 "rocinante log shift", true);
}

}  // namespace rocinante
