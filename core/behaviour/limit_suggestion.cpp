#include "core/behaviour/limit_suggestion.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

#include "core/behaviour/run_judge.h"

namespace rocinante {
namespace {

constexpr double kMargin = 2;
constexpr double kSeen = 0.1;  ///< share of a limit from which on what differs is seen
constexpr std::size_t kOneIn = 20;

using Sessions = std::vector<const SessionTrack*>;

Sessions without(const Sessions& sessions, std::size_t place) {
  Sessions others = sessions;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(place));
  return others;
}

/// With a margin, rounded up to two digits.
double limitFor(double largest) {
  const double wanted = largest * kMargin;
  const double digit = std::pow(10, std::floor(std::log10(wanted)) - 1);
  return std::ceil(wanted / digit - 1e-9) * digit;
}

void raise(std::optional<double>& limit, double to) { limit = std::max(limit.value_or(0), to); }

/// False when the run's own limit allows it.
bool keep(std::optional<double>& limit, double its) {
  if (limit && *limit <= its) limit.reset();
  return limit.has_value();
}

/// Leaves out what the run's own limits allow.
void dropWhatHolds(const RunSpec& spec, std::map<std::string, OwnLimits, std::less<>>& limits) {
  for (auto entry = limits.begin(); entry != limits.end();) {
    auto& [item, own] = *entry;
    const RunLimits known = spec.limitsOf(item);
    const bool joint = keep(own.joint_deg, known.joint_deg);
    const bool position = keep(own.position_mm, known.position_mm);
    const bool turn = keep(own.turn_deg, known.turn_deg);
    const bool pose = keep(own.pose_mm, known.ofPose_mm());
    const bool pose_turn = keep(own.pose_deg, known.ofPose_deg());
    const bool signal = keep(own.signal, known.signal.value_or(0));
    entry = joint || position || turn || pose || pose_turn || signal ? std::next(entry)
                                                                     : limits.erase(entry);
  }
}

/// The limits alone, without how good they are.
LimitSuggestion limitsOf(const RunSpec& spec, const Sessions& sessions) {
  LimitSuggestion found;
  // How late events come first: it widens every band.
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    for (const RunFinding& finding : judgeRun(spec, without(sessions, i), *sessions[i]).findings) {
      if (finding.kind != RunFinding::Kind::event || !finding.largest) continue;
      found.event_ms = std::max(found.event_ms, limitFor(*finding.largest));
    }
  }
  const RunSpec patient = found.appliedTo(spec);
  // What a recording stays within its limit by counts, too: the next one may not.
  RunSpec strict = patient;
  strict.own_limits.clear();
  for (auto* limit :
       {&strict.limits.joint_deg, &strict.limits.position_mm, &strict.limits.turn_deg}) {
    *limit *= kSeen;
  }
  strict.limits.pose_mm = strict.limits.pose_deg = std::nullopt;
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    const Sessions others = without(sessions, i);
    for (const RunFinding& finding : judgeRun(patient, others, *sessions[i]).findings) {
      if (finding.accept.empty()) found.beyond.insert(finding.what);
    }
    for (const RunFinding& finding : judgeRun(strict, others, *sessions[i]).findings) {
      if (finding.accept.empty()) continue;
      OwnLimits& own = found.own_limits[finding.item];
      const bool is_length = finding.unit == "mm";
      const bool is_pose = finding.kind == RunFinding::Kind::pose;
      if (finding.kind == RunFinding::Kind::signal) {
        raise(own.signal, limitFor(*finding.largest));
        continue;
      }
      const bool is_own_pose = is_pose && finding.item.find('/') == std::string::npos;
      raise(is_own_pose ? (is_length ? own.pose_mm : own.pose_deg)
            : is_length ? own.position_mm
            : is_pose   ? own.turn_deg
                        : own.joint_deg,
            limitFor(*finding.largest));
    }
  }
  dropWhatHolds(patient, found.own_limits);
  return found;
}

bool isAlarm(const RunSpec& spec, const Sessions& sessions, std::size_t place) {
  const RunJudgement judged = judgeRun(spec, without(sessions, place), *sessions[place]);
  return !judged.comparable || !judged.findings.empty();
}

std::string entriesOf(const OwnLimits& limits) {
  std::string text;
  const auto add = [&](const char* key, const std::optional<double>& limit) {
    if (limit) text += fmt::format("{}{} = {:.6g}", text.empty() ? "" : ", ", key, *limit);
  };
  add("joint_deg", limits.joint_deg);
  add("position_mm", limits.position_mm);
  add("turn_deg", limits.turn_deg);
  add("pose_mm", limits.pose_mm);
  add("pose_deg", limits.pose_deg);
  add("signal", limits.signal);
  add("signal_share", limits.signal_share);
  add("event_ms", limits.event_ms);
  return text;
}

}  // namespace

std::size_t LimitSuggestion::wanted() const {
  const std::size_t needed = kOneIn * (alarms + 1) - 2;
  return needed > recordings ? needed - recordings : 0;
}

RunSpec LimitSuggestion::appliedTo(RunSpec spec) const {
  spec.limits.event_ms = std::max(spec.limits.event_ms, event_ms);
  for (const auto& [item, limits] : own_limits) {
    const RunLimits known = spec.limitsOf(item);
    OwnLimits& own = spec.own_limits[item];
    if (limits.joint_deg) own.joint_deg = std::max(known.joint_deg, *limits.joint_deg);
    if (limits.position_mm) own.position_mm = std::max(known.position_mm, *limits.position_mm);
    if (limits.turn_deg) own.turn_deg = std::max(known.turn_deg, *limits.turn_deg);
    if (limits.pose_mm) own.pose_mm = std::max(known.ofPose_mm(), *limits.pose_mm);
    if (limits.pose_deg) own.pose_deg = std::max(known.ofPose_deg(), *limits.pose_deg);
    if (limits.signal) own.signal = std::max(known.signal.value_or(0), *limits.signal);
  }
  return spec;
}

std::string LimitSuggestion::toml(const RunSpec& spec) const {
  const RunSpec applied = appliedTo(spec);
  const RunLimits& run = applied.limits;
  OwnLimits ofRun;
  if (run.joint_deg > kRunFloors.joint_deg) ofRun.joint_deg = run.joint_deg;
  if (run.link_positions) ofRun.position_mm = run.position_mm;
  if (run.link_turns) ofRun.turn_deg = run.turn_deg;
  ofRun.pose_mm = run.pose_mm;
  ofRun.pose_deg = run.pose_deg;
  if (run.signal_share != kRunFloors.signal_share) ofRun.signal_share = run.signal_share;
  if (run.event_ms > kRunFloors.event_ms) ofRun.event_ms = run.event_ms;
  std::string text = entriesOf(ofRun);
  for (const auto& [item, limits] : applied.own_limits) {
    text += fmt::format("{}\"{}\" = {{ {} }}", text.empty() ? "" : ", ", item, entriesOf(limits));
  }
  return text.empty() ? text : fmt::format("limits = {{ {} }}", text);
}

LimitSuggestion suggestLimits(const RunSpec& spec, const Sessions& sessions,
                              const ParallelFor& parallel) {
  LimitSuggestion found = limitsOf(spec, sessions);
  found.recordings = sessions.size();
  std::atomic<std::size_t> before = 0, after = 0;
  forEachIndex(parallel, sessions.size(), [&](std::size_t i) {
    if (!isAlarm(spec, sessions, i)) return;
    ++before;
    // What is within the run's own limits is within wider ones.
    const LimitSuggestion of_others = limitsOf(spec, without(sessions, i));
    if (isAlarm(of_others.appliedTo(spec), sessions, i)) ++after;
  });
  found.alarms_before = before;
  found.alarms = after;
  return found;
}

}  // namespace rocinante
