#include "player/play.h"

#include <algorithm>
#include <utility>

#include "core/duration_text.h"
#include "core/session/timeline.h"
#include "player/log_merge.h"
#include "player/play_stream.h"
#include "player/read_ahead.h"

namespace rocinante {
namespace {

// Time to send a first restatement before the first message is due.
constexpr Nanoseconds kRestateAhead = std::chrono::milliseconds(5);

std::string namesOf(const std::vector<std::filesystem::path>& paths) {
  std::string names;
  for (const auto& path : paths) names += (names.empty() ? "" : ", ") + path.string();
  return names;
}

Result<PlayedSpan> spanOf(const LogMerge& logs, const PlayOptions& options) {
  PlayedSpan span{logs.start(), logs.end() + Nanoseconds(1)};
  if (options.from) {
    const auto from = parseSessionTime(*options.from, logs.origin(), logs.end());
    if (!from) return from.error();
    // Before the first message there is nothing to wait for.
    span.from = std::max(*from, logs.start());
  }
  if (options.until) {
    const auto until = parseSessionTime(*options.until, logs.origin(), logs.end());
    if (!until) return until.error();
    span.until = *until;
  }
  return span;
}

Status checkSpan(LogMerge& logs, const PlayedSpan& span, const PlayOptions& options) {
  const Error nothing{ErrorKind::not_found,
                      "nothing to play: no captured message from " +
                          secondsText(span.from - logs.origin()) + " s until " +
                          secondsText(span.until - logs.origin()) + " s",
                      namesOf(options.logs)};
  if (logs.messages() == 0) {
    return Error{ErrorKind::not_found, "nothing to play: no captured message",
                 namesOf(options.logs)};
  }
  if (span.from >= span.until) return nothing;
  if (const Status found = logs.seek(span.from, LogMerge::Which::captured); !found) return found;
  const Result<std::optional<LogMessage>> first = logs.next();
  if (!first) return first.error();
  if (!*first || (*first)->log_time >= span.until) return nothing;
  return {};
}

}  // namespace

Result<PlayReport> play(const PlayOptions& options, const SendSurroundings& surroundings) {
  Result<LogMerge> logs = LogMerge::open(options.logs);
  if (!logs) return logs.error();
  const Result<PlayedSpan> span = spanOf(*logs, options);
  if (!span) return span.error();
  if (const Status judged = checkSpan(*logs, *span, options); !judged) return judged.error();

  PlayStream::Options how;
  how.span = *span;
  how.turns = options.turns;
  how.restate = options.restate;
  if (options.restate) how.restate_ahead = options.speed.logDuration(kRestateAhead);
  Result<PlayStream> stream = PlayStream::open(*logs, how);
  if (!stream) return stream.error();

  surroundings.told(
      "playing " + namesOf(options.logs) + " to " + options.to.text() +
      (options.at_once ? std::string(" at once") : " at " + options.speed.text() + "x"));
  SendPlan plan;
  plan.to = options.to;
  if (!options.at_once) plan.speed = options.speed;
  plan.first = span->from - how.restate_ahead;
  plan.from = span->from;
  plan.until = span->until;
  plan.origin = logs->origin();
  plan.last = std::min(span->until, logs->end());
  plan.realtime = options.realtime;
  plan.progress = options.progress;
  Result<PlayReport> report = [&] {
    ReadAhead ahead(*stream);
    return sendPlan(ahead, plan, surroundings.stop);
  }();
  if (!report) return report;
  for (const auto& log : options.logs) report->inputs.push_back(log.string());
  report->damage = logs->damage();
  return report;
}

}  // namespace rocinante
