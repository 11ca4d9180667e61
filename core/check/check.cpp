#include "core/check/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "core/base/figure_text.h"
#include "core/cell/cell.h"
#include "core/check/judges/tally.h"
#include "core/check/rules/check_report.h"
#include "core/check/rules/rule_settings.h"
#include "core/check/session_check.h"
#include "core/log/import_record.h"
#include "core/log/log_profile.h"
#include "core/log/octets_before.h"
#include "core/report/finding.h"
#include "core/session/keyframe.h"
#include "core/session/log_pieces.h"

namespace rocinante {
namespace {

/// A limit in radians is hardly a whole number as large as this.
constexpr double kLeastDegrees = 30;

bool isWhole(double value) { return std::abs(value - std::round(value)) < 1e-9; }

bool looksLikeDegrees(const JointLimits& limits) {
  return std::max(std::abs(limits.lower), std::abs(limits.upper)) >= kLeastDegrees &&
         isWhole(limits.lower) && isWhole(limits.upper);
}

/// Limits of the cell's models that are valid and hardly meant: angles in degrees, which no value
/// in radians exceeds, and speeds of 0.
void judgeModelUnits(const Cell& cell, Findings& findings) {
  // A model may have several names, such as its file's and its own: the shortest is shown.
  std::map<const Model*, std::string> names;
  for (const auto& [name, model] : cell.models) {
    if (model == nullptr) continue;
    const auto [place, is_new] = names.try_emplace(model.get(), name);
    if (!is_new && name.size() < place->second.size()) place->second = name;
  }
  for (const auto& [name, model] : cell.models) {
    if (model == nullptr || names.at(model.get()) != name) continue;
    std::size_t turning = 0, degrees = 0, still = 0;
    std::string first, first_still;
    for (const Joint& joint : model->joints) {
      const bool turns = joint.type == JointType::revolute;
      if (!joint.limits) continue;
      const bool moves =
          turns || joint.type == JointType::prismatic || joint.type == JointType::continuous;
      if (moves && joint.limits->velocity && *joint.limits->velocity == 0) {
        if (still++ == 0) first_still = joint.name;
      }
      if (!turns) continue;
      ++turning;
      if (!looksLikeDegrees(*joint.limits)) continue;
      if (degrees++ == 0) {
        first = fmt::format("{} [{:.6g}, {:.6g}]", joint.name, joint.limits->lower,
                            joint.limits->upper);
      }
    }
    if (degrees > 0 && 2 * degrees >= turning) {
      findings.push_back(makeFinding(
          "model.degrees", name,
          fmt::format("the limits of {} of model {} look like degrees, such as {}: no value in "
                      "radians exceeds them, so joint.limit and joint.degrees find nothing",
                      countText(degrees, "joint"), name, first)));
      findings.back().hint = "URDF and SDF take radians: multiply by pi / 180";
    }
    if (still > 0) {
      findings.push_back(makeFinding(
          "model.zero-velocity", name,
          fmt::format("the velocity limit of {} of model {} is 0, such as {}: it is taken as none, "
                      "so joint.velocity finds nothing",
                      countText(still, "joint"), name, first_still)));
      findings.back().hint = "write the largest speed, in rad/s or m/s";
    }
  }
}

/// How often progress is reported.
constexpr std::uint64_t kProgressMessages = 2048;

CheckReport reportOfCell(const Cell& cell, bool has_session) {
  CheckReport report;
  report.has_session = has_session;
  report.unjudged = unjudgedRules(cell, has_session);
  report.cell = cell.file;
  report.findings = cell.faults;
  judgeModelUnits(cell, report.findings);
  judgeRuleNames(cell, report.findings);
  report.rules = RuleSettings(cell.rules);
  const Findings& of_rules = report.rules.faults();
  report.findings.insert(report.findings.end(), of_rules.begin(), of_rules.end());
  return report;
}

}  // namespace

CheckReport checkCell(const Cell& cell) {
  CheckReport report = reportOfCell(cell, false);
  conclude(report);
  return report;
}

CheckReport checkSession(const Cell& cell, const SessionCheck& session) {
  CheckReport report = reportOfCell(cell, true);
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

/// Octets of a channel with a decoder wait for the next message, which is their packet or not.
class WaitingOctets {
 public:
  explicit WaitingOctets(const LogReader& log) {
    for (const LogChannel& channel : log.channels()) {
      if (channel.decoded()) decoded_.emplace(profile::capturedTopic(channel.topic));
    }
  }

  /// Judges those that waited. True when the message itself waits now.
  bool take(const LogMessage& message, SessionCheck& session) {
    // What an import made no packet of, log.import tells.
    const bool is_decoded = waiting_ && before_.areOf(message);
    if (waiting_ && (is_decoded || !imported_)) session.addOctets(time_, encoding_, is_decoded);
    before_.take(message);
    const LogChannel& channel = *message.channel;
    waiting_ = !decoded_.empty() && channel.captured() && channel.encoding != "rk1" &&
               decoded_.contains(channel.topic);
    time_ = message.log_time;
    encoding_ = channel.encoding;
    imported_ = channel.imported();
    return waiting_;
  }

  void finish(SessionCheck& session) {
    if (std::exchange(waiting_, false) && !imported_) session.addOctets(time_, encoding_, false);
  }

 private:
  std::set<std::string, std::less<>> decoded_;  ///< topics whose octets have packets
  OctetsBefore before_;
  bool waiting_ = false, imported_ = false;
  LogTime time_{};
  std::string_view encoding_;  ///< of the reader's channel
};

}  // namespace

Result<CheckReport> checkLog(const Cell& cell, LogReader& log,
                             const std::function<bool(double)>& progress,
                             const OctetPackets& packets) {
  if (Status status = log.rewind(); !status) return status.error();
  SessionCheck session(cell);
  const LogTime start = log.summary().start;
  const double span = std::max(1.0, static_cast<double>((log.summary().end - start).count()));
  WaitingOctets octets(log);
  bool is_first = true, interrupted = false;
  for (std::uint64_t messages = 0;; ++messages) {
    const Result<std::optional<LogMessage>> next = log.next();
    if (!next) return next.error();
    if (!*next) break;
    const LogMessage& message = **next;
    const auto tell = [&](const DecodedOctets& made) {
      for (const NotFiniteField& each : made.not_finite) {
        session.addNotFinite(message.log_time, each);
      }
    };
    if (progress && messages % kProgressMessages == 0) {
      const double done = static_cast<double>((message.log_time - start).count()) / span;
      interrupted = !progress(std::clamp(done, 0.0, 1.0));
      if (interrupted) break;
    }
    if (octets.take(message, session)) {
      is_first = false;
      if (packets && !message.channel->imported()) tell(packets(message, true));
      continue;
    }
    const bool is_keyframe = isKeyframeChannel(*message.channel);
    if (is_keyframe && is_first) addPreceding(session, message);
    is_first = is_first && !is_keyframe && !message.channel->folded();
    if (message.channel->topic == profile::kClockTopic) {
      session.addClockStep(message.log_time, message.payload);
    }
    if (!message.channel->folded()) continue;
    // Of another program: its messages need not be packets, and log.import says what was wrong.
    if (message.channel->imported() && message.channel->captured() &&
        message.channel->encoding != "rk1") {
      continue;
    }
    if (packets && message.channel->captured() && message.channel->encoding != "rk1") {
      const DecodedOctets made = packets(message, false);
      tell(made);
      session.addOctets(message.log_time, message.channel->encoding, !made.packet.empty());
      if (!made.packet.empty()) session.add(message.log_time, "rk1", false, bytesOf(made.packet));
      continue;
    }
    const auto sender = message.channel->metadata.find("remote");
    session.add(message.log_time, message.channel->encoding, message.channel->captured(),
                message.payload,
                sender != message.channel->metadata.end() ? sender->second : std::string_view());
  }
  octets.finish(session);
  for (const LossSpan& loss : log.losses()) session.addLoss(loss);
  const std::uint64_t file_bytes = log.storage().file_bytes;
  for (const DamageSpan& damage : log.damage()) {
    // A killed recorder leaves no summary and an open last chunk, which is read. log.incomplete
    // reports both; neither is damage.
    const bool at_end = damage.to == file_bytes && !damage.messages_lost;
    const bool is_torn_end = !log.summary().complete && at_end;
    if (damage.from != damage.to && !is_torn_end) session.addDamage(damage);
  }
  for (std::string& text : importWarningsOf(log.metadata())) {
    session.addImportWarning(std::move(text));
  }
  Account missed, notes;
  const Account imported = accountOfLines(importLeftOutOf(log.metadata()));
  for (const LeftOut& one : imported.leftOut()) {
    (one.severity == Severity::note ? notes : missed).leaveOut(one);
  }
  if (NextPiece::missing(log)) notes.leaveOut({.kind = "piece", .reason = kGoesOn});
  if (!missed.empty()) session.addImportWarning(accountSentence(missed));
  session.addLeftOut(notes);
  if (!log.summary().complete) session.noteIncomplete();
  session.settle();
  CheckReport report = checkSession(cell, session);
  report.interrupted = interrupted;
  if (interrupted) conclude(report);
  report.session = log.name();
  report.origin = log.summary().origin;
  report.duration = log.summary().end - log.summary().start;
  return report;
}

}  // namespace rocinante
