#include "core/check/check.h"

#include <algorithm>

#include "core/check/session_check.h"
#include "core/log/log_profile.h"
#include "core/session/keyframe.h"

namespace rocinante {
namespace {

/// How often progress is reported.
constexpr std::uint64_t kProgressMessages = 2048;

Finding findingOf(const ModelFault& fault) {
  Finding finding;
  finding.rule = fault.rule;
  finding.severity = fault.severity;
  finding.text = fault.text;
  finding.hint = fault.hint;
  finding.file = fault.file;
  finding.line = fault.line;
  finding.column = fault.column;
  return finding;
}

CheckReport reportOfCell(const Cell& cell) {
  CheckReport report;
  report.cell = cell.file;
  for (const ModelFault& fault : cell.faults) report.findings.push_back(findingOf(fault));
  report.rules = RuleSettings(cell.rules);
  for (const ModelFault& fault : report.rules.faults()) {
    report.findings.push_back(findingOf(fault));
  }
  return report;
}

}  // namespace

CheckReport checkCell(const Cell& cell) {
  CheckReport report = reportOfCell(cell);
  conclude(report);
  return report;
}

CheckReport checkSession(const Cell& cell, const SessionCheck& session) {
  CheckReport report = reportOfCell(cell);
  report.has_session = true;
  session.finish(report);
  conclude(report);
  return report;
}

namespace {

/// A piece of a session opens with the preceding state as packets: judged like any restatement.
void addPreceding(SessionCheck& session, const LogMessage& keyframe) {
  if (!KeyframeReader().read(keyframe.payload, keyframe.log_time)) return;
  for (const std::string_view datagram : keyframeDatagrams(keyframe.payload)) {
    session.add(keyframe.log_time, "rk1", false, bytesOf(datagram));
  }
}

}  // namespace

Result<CheckReport> checkLog(const Cell& cell, LogReader& log,
                             const std::function<bool(double)>& progress) {
  if (Status status = log.rewind(); !status) return status.error();
  SessionCheck session(cell);
  const LogTime start = log.summary().start;
  const double span = std::max(1.0, static_cast<double>((log.summary().end - start).count()));
  bool is_first = true, interrupted = false;
  for (std::uint64_t messages = 0;; ++messages) {
    const Result<std::optional<LogMessage>> next = log.next();
    if (!next) return next.error();
    if (!*next) break;
    const LogMessage& message = **next;
    if (progress && messages % kProgressMessages == 0) {
      const double done = static_cast<double>((message.log_time - start).count()) / span;
      interrupted = !progress(std::clamp(done, 0.0, 1.0));
      if (interrupted) break;
    }
    const bool is_keyframe = isKeyframeChannel(*message.channel);
    if (is_keyframe && is_first) addPreceding(session, message);
    is_first = is_first && !is_keyframe && !message.channel->folded();
    if (message.channel->topic == profile::kClockTopic) {
      session.addClockStep(message.log_time, message.payload);
    }
    if (!message.channel->folded()) continue;
    session.add(message.log_time, message.channel->encoding, message.channel->captured(),
                message.payload);
  }
  for (const LossSpan& loss : log.losses()) session.addLoss(loss);
  const std::uint64_t file_bytes = log.storage().file_bytes;
  for (const DamageSpan& damage : log.damage()) {
    // A killed recorder leaves no summary and an open last chunk, which is read. log.incomplete
    // reports both; neither is damage.
    const bool at_end = damage.to == file_bytes && !damage.messages_lost;
    const bool is_torn_end = !log.summary().complete && at_end;
    if (damage.from != damage.to && !is_torn_end) session.addDamage(damage);
  }
  if (!log.summary().complete) session.noteIncomplete();
  CheckReport report = checkSession(cell, session);
  report.interrupted = interrupted;
  if (interrupted) conclude(report);
  report.session = log.name();
  report.origin = log.summary().origin;
  report.duration = log.summary().end - log.summary().start;
  return report;
}

}  // namespace rocinante
