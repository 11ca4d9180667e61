#include "core/check/judges/log_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/duration_text.h"
#include "core/base/figure_text.h"
#include "core/check/judges/tally.h"
#include "core/log/clock_message.h"

namespace rocinante {

void LogJudge::takeClockStep(LogTime time, ByteView payload) {
  const std::optional<ClockStep> step = parseClockStep(payload);
  if (!step) return;
  const double seconds = static_cast<double>(step->step.count()) * 1e-9;
  if (std::abs(seconds) > std::abs(worst_step_s_)) worst_step_s_ = seconds;
  clock_steps_.count = clock_steps_.first ? clock_steps_.count + 1 : 1;
  clock_steps_.first = std::min(clock_steps_.first.value_or(time), time);
  clock_steps_.last = std::max(clock_steps_.last.value_or(time), time);
  clock_steps_.when.hit(time);
}

void LogJudge::noteJump(LogTime from, LogTime to) {
  if (!jumps_.first) {
    jumps_ = makeFinding(
        "log.clock-set", "",
        fmt::format(
            "the times jump by {}, from {} to {}: the clock was set while this was recorded",
            roughDuration(to - from), rfc3339Text(WallTime(from.time_since_epoch())),
            rfc3339Text(WallTime(to.time_since_epoch()))));
    jumps_.count = 0;
    jumps_.first = to;
  }
  ++jumps_.count;
  jumps_.last = to;
  jumps_.when.hit(to);
}

void LogJudge::report(Findings& findings) const {
  for (const auto& [endpoint, spans] : losses_) reportLoss(endpoint, spans, findings);
  if (clock_steps_.first) {
    Finding finding = makeFinding(
        "log.clock-step", "",
        fmt::format("the recorder's wall clock was set {} by {:.6g} s; the log's own times are "
                    "unaffected",
                    worst_step_s_ < 0 ? "back" : "forward", std::abs(worst_step_s_)));
    finding.count = clock_steps_.count;
    finding.first = clock_steps_.first;
    finding.last = clock_steps_.last;
    finding.when = clock_steps_.when;
    findings.push_back(std::move(finding));
  }
  if (jumps_.first) findings.push_back(jumps_);
  for (const DamageSpan& span : damage_) {
    std::string text =
        fmt::format("bytes {} to {} of the log cannot be used: {}", span.from, span.to, span.cause);
    if (span.messages_lost)
      text += fmt::format(" ({} lost)", countText(*span.messages_lost, "message"));
    findings.push_back(makeFinding("log.damage", "", std::move(text)));
  }
  for (const std::string& text : import_warnings_) {
    findings.push_back(makeFinding("log.import", "", text));
  }
  if (!left_out_.empty()) {
    findings.push_back(makeFinding("log.left-out", "", accountSentence(left_out_)));
    findings.back().count = left_out_.total();
  }
  if (is_incomplete_) {
    findings.push_back(makeFinding("log.incomplete", "",
                                   "the recorder did not close the log: its end may be missing"));
  }
}

void LogJudge::reportLoss(const std::string& endpoint, const std::vector<LossSpan>& spans,
                          Findings& findings) const {
  LossCounts sum;
  for (const LossSpan& span : spans) sum += span.counts;
  const std::uint64_t lost = sum.kernel + sum.queue + sum.disk;
  if (lost == 0 && sum.truncated == 0) return;
  std::string text = fmt::format(
      "datagrams to {} that were not recorded: {} by the kernel, {} by the queue, {} by the disk",
      endpoint, sum.kernel, sum.queue, sum.disk);
  if (sum.truncated > 0) text += fmt::format("; {} more are truncated", sum.truncated);
  Finding finding = makeFinding("log.loss", endpoint, std::move(text));
  finding.count = lost > 0 ? lost : sum.truncated;
  finding.first = spans.front().from;
  finding.last = spans.front().until;
  for (const LossSpan& span : spans) {
    finding.first = std::min(*finding.first, span.from);
    finding.last = std::max(*finding.last, span.until);
    const std::uint64_t count = span.counts.kernel + span.counts.queue + span.counts.disk;
    finding.when.hit(span.from, static_cast<std::uint32_t>(std::clamp<std::uint64_t>(
                                    count, 1, std::numeric_limits<std::uint32_t>::max())));
  }
  findings.push_back(std::move(finding));
}

}  // namespace rocinante
