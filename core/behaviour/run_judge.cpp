#include "core/behaviour/run_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include "core/base/figure_text.h"
#include "core/behaviour/motion_judge.h"
#include "core/behaviour/run_coverage.h"
#include "core/packet/item_text.h"

namespace rocinante {
namespace {

/// Less than this beyond the accepted end is not worth a note.
constexpr Nanoseconds kTellsOfMore = std::chrono::milliseconds(500);
/// Motion within `event_ms` of this many limits is worth a note.
constexpr double kTellsOfFast = 10;
/// A session that has less of the accepted time is another one.
constexpr double kLeastShare = 0.5;

void addNotes(const RunTimes& times, RunJudgement& judged) {
  const Nanoseconds after_end(times.runEnd() - times.end());
  const Nanoseconds late(times.runBegin());
  if (after_end > kTellsOfMore) {
    judged.notes.push_back(
        fmt::format("the last {:.1f} s of the log are after the accepted end and were not judged",
                    secondsOf(after_end)));
  }
  if (-after_end > kTellsOfMore) {
    judged.notes.push_back(
        fmt::format("the log ends {:.1f} s before the accepted one; its last state was held",
                    secondsOf(-after_end)));
  }
  if (-late > kTellsOfMore) {
    judged.notes.push_back(fmt::format(
        "the log begins {:.1f} s before the accepted one; what is before that was not judged",
        secondsOf(-late)));
  }
  if (late > kTellsOfMore) {
    judged.notes.push_back(
        fmt::format("the log begins {:.1f} s after the accepted one; what was before was not "
                    "judged",
                    secondsOf(late)));
  }
}

/// What may hide in the motion that is fastest beside its limit.
void addFastest(const RunTimes& times, const FastMotion& fastest, RunJudgement& judged) {
  if (fastest.times_limit < kTellsOfFast) return;
  judged.notes.push_back(fmt::format(
      "{} moves by {} in {}, at {:.3f} s: a packet that is wrong by less may hide there",
      fastest.item, figureText(fastest.figure, fastest.unit),
      figureText(times.spec.limitsOf(fastest.item).event_ms, "ms"),
      secondsOf(times.sinceOrigin(fastest.at))));
}

/// Everything that some session has facts of.
std::set<std::string> factsOf(const RunTimes& times) {
  std::set<std::string> names;
  times.eachSession([&](const SessionTrack& track) {
    for (const auto& [name, changes] : track.facts) names.insert(name);
  });
  return names;
}

/// A session that has little of the accepted time says little of it. False: it has most of it.
bool judgeShare(const RunTimes& times, RunJudgement& judged) {
  const double whole = static_cast<double>(times.end()) * 1e-9;
  const std::int64_t from = std::max<std::int64_t>(0, times.runBegin());
  const double share = static_cast<double>(std::min(times.runEnd(), times.end()) - from) * 1e-9;
  if (share >= kLeastShare * whole || whole - share < secondsOf(kTellsOfMore)) {
    return false;
  }
  RunFinding finding = times.findingOfAll(RunFinding::Kind::coverage, "session");
  finding.what = fmt::format("the log has {:.1f} s of the {:.1f} s that were accepted",
                             std::max(share, 0.0), whole);
  judged.findings.push_back(std::move(finding));
  return true;
}

/// A log that ends early is the cause of what is missing after its end, and of what stands still
/// there.
void judgeEnd(const RunTimes& times, std::vector<RunFinding>& findings) {
  const Nanoseconds short_by(times.end() - times.runEnd());
  if (short_by.count() <= times.reachOf(times.spec.limits)) return;
  const Nanoseconds from = times.sinceOrigin(times.runEnd()) - kInterpolated;
  std::optional<Nanoseconds> first;
  for (const RunFinding& finding : findings) {
    const bool has_time = finding.kind >= RunFinding::Kind::event;
    if (!has_time || finding.first_accepted < from) continue;
    first = std::min(first.value_or(finding.first_accepted), finding.first_accepted);
  }
  if (!first) return;
  RunFinding finding = times.findingOfAll(RunFinding::Kind::rate, "session");
  finding.first_accepted = finding.at_accepted = *first;
  finding.first_run = finding.at_run = times.sinceRunOrigin(times.runEnd());
  finding.sorts_at = *first - Nanoseconds(1);
  finding.what = fmt::format("the log ends {} before the accepted one",
                             short_by < std::chrono::seconds(1)
                                 ? figureText(secondsOf(short_by) * 1e3, "ms")
                                 : fmt::format("{:.1f} s", secondsOf(short_by)));
  findings.push_back(std::move(finding));
}

/// "drawing/planner/path\t2"
bool isFurtherPart(const std::string& fact) {
  return fact.starts_with("drawing/") && itemOfFact(fact) != fact;
}

/// Of a drawing the part that differs first is named. `before`: findings without the last part's.
void keepFirstPart(std::vector<RunFinding>& findings, std::size_t before) {
  if (findings.size() == before || before == 0) return;
  RunFinding& other = findings[before - 1];
  RunFinding& last = findings.back();
  if (other.kind != RunFinding::Kind::drawing || other.item != last.item) return;
  const Nanoseconds until = std::max(other.until_accepted, last.until_accepted);
  std::vector<RunSpan> spans = other.spans;
  spans.insert(spans.end(), last.spans.begin(), last.spans.end());
  std::ranges::sort(spans, {}, &RunSpan::from);
  if (last.first_accepted < other.first_accepted) other = std::move(last);
  other.until_accepted = until;
  other.spans = joined(std::move(spans), Nanoseconds(0));
  findings.pop_back();
}

/// A fact of a signal that no accepted session states as that. Of a number, whose fact is its unit,
/// judgeNumbers() tells.
bool isOfNewSignal(const RunTimes& times, const std::string& fact) {
  const std::string item = itemOfFact(fact);
  if (!signalNamed(item) || (fact != item && fact != unitFact(item))) return false;
  const auto has = [&](const SessionTrack* track) {
    return fact == item ? track->facts.contains(fact) || track->numbers.contains(item)
                        : track->numbers.contains(item);
  };
  return std::ranges::none_of(times.accepted, has) || (fact != item && !has(&times.run));
}

void judgeMotion(const RunTimes& times, const ParallelFor& parallel, RunJudgement& judged) {
  const bool is_short = judgeShare(times, judged);
  addFastest(times, judgeDevices(times, parallel, judged), judged);
  judgeSignalRates(times, parallel, judged);
  judgeNumbers(times, parallel, judged);
  for (const std::string& fact : factsOf(times)) {
    if (times.spec.isMaskedThroughout(itemOfFact(fact))) continue;
    if (isOfNewSignal(times, fact)) {
      if (times.run.is_imported && fact == itemOfFact(fact)) {
        judged.coverage.left_out.leaveOut({"signal", fact, kNotAcceptedSignal});
      }
      if (times.run.is_imported || fact != itemOfFact(fact)) continue;
    }
    const std::size_t before = judged.findings.size();
    judgeFact(times, fact, judged.findings);
    if (isFurtherPart(fact)) keepFirstPart(judged.findings, before);
  }
  if (!is_short) judgeEnd(times, judged.findings);
}

/// By what may have caused what: see RunFinding::sorts_at.
void sortByCause(std::vector<RunFinding>& findings) {
  for (RunFinding& finding : findings) {
    if (finding.sorts_at == Nanoseconds(0)) finding.sorts_at = finding.first_accepted;
  }
  for (RunFinding& link : findings) {
    const std::size_t slash = link.item.find('/');
    if (link.kind != RunFinding::Kind::pose || slash == std::string::npos) continue;
    for (const RunFinding& joint : findings) {
      const bool moves_it = joint.kind == RunFinding::Kind::joint &&
                            joint.item.compare(0, slash + 1, link.item, 0, slash + 1) == 0;
      if (moves_it) link.sorts_at = std::max(link.sorts_at, joint.sorts_at);
    }
  }
  std::stable_sort(findings.begin(), findings.end());
}

/// Of the coverage, but for what is an event alone.
std::size_t itemsJudged(const RunCoverage& coverage,
                        const std::vector<const SessionTrack*>& accepted, const SessionTrack& run) {
  std::set<std::string> events;
  std::vector<const SessionTrack*> tracks = accepted;
  tracks.push_back(&run);
  for (const SessionTrack* track : tracks) {
    for (const Event& event : track->events) events.insert(itemOf(event));
  }
  // A device may be named "event".
  for (const SessionTrack* track : tracks) {
    for (const auto& [name, device] : track->devices) {
      for (const TrackColumn& column : device.columns) events.erase(itemOf(name, column));
    }
  }
  return static_cast<std::size_t>(std::ranges::count_if(
      coverage.judged, [&](const std::string& item) { return !events.contains(item); }));
}

/// Whether how often a device is stated was judged.
bool hasRates(const RunTimes& times) {
  const SessionTrack& first = *times.accepted.front();
  return std::ranges::any_of(times.run.devices, [&](const auto& device) {
    const auto accepted = first.devices.find(device.first);
    return !times.spec.isMaskedThroughout(device.first) && isStated(device.second) &&
           accepted != first.devices.end() && isStated(accepted->second);
  });
}

/// Why nothing was judged, so that there is no verdict.
std::string nothingJudged(const RunJudgement& judged) {
  if (!judged.coverage.masked.empty() && judged.coverage.lost.empty()) {
    return fmt::format("nothing was judged: the suite masks all {}",
                       countText(judged.coverage.masked.size(), "item"));
  }
  const std::string left_out = accountBrief(judged.coverage.left_out);
  return "nothing was judged: no device of the cell gets a value from the accepted sessions" +
         (left_out.empty() ? "" : "; " + left_out);
}

}  // namespace

std::string runRule(const RunJudgement& judged) {
  const std::string against = countText(judged.accepted, "accepted session");
  if (judged.findings.empty()) {
    return fmt::format("{} and {} within the limits of {}", countText(judged.items, "item"),
                       countText(judged.events, "event"), against);
  }
  std::string rule = judged.findings.front().what;
  if (judged.findings.size() > 1) {
    rule += fmt::format("; and {} more", judged.findings.size() - 1);
  }
  return rule;
}

RunJudgement judgeRun(const RunSpec& spec, const std::vector<const SessionTrack*>& accepted,
                      const SessionTrack& run, const ParallelFor& parallel) {
  RunJudgement judged;
  const SessionTrack& first = *accepted.front();
  judged.accepted = accepted.size();
  judged.from = first.start - first.origin;
  judged.until = first.end - first.origin;
  RunEvents events = judgeEvents(spec, accepted, run);
  judged.coverage = coverageOf(spec, accepted, run);
  judged.items = itemsJudged(judged.coverage, accepted, run);
  judged.events = static_cast<std::size_t>(std::ranges::count_if(
      first.events, [&](const Event& event) { return !spec.isMaskedThroughout(itemOf(event)); }));
  const auto cannotAlign = [&](const EventAlignment& alignment) {
    return spec.align == RunAlign::events && alignment.matched.empty();
  };
  if (cannotAlign(events.run) || std::ranges::any_of(events.accepted, cannotAlign)) {
    judged.rule =
        "no event in common to align by; `align = \"origin\"` compares from the first datagrams";
    return judged;
  }
  judged.comparable = true;
  if (spec.align == RunAlign::warp) {
    const auto bend = [&](const SessionTrack& track, TimeMap& map,
                          const EventAlignment& alignment) {
      map = warpedMap(first, track, map, !alignment.matched.empty(), spec.warp);
    };
    bend(run, events.run_map, events.run);
    for (std::size_t i = 1; i < accepted.size(); ++i) {
      bend(*accepted[i], events.accepted_maps[i], events.accepted[i - 1]);
    }
  }
  const RunTimes times{spec, accepted, run, std::move(events.accepted_maps), events.run_map};
  judged.times = std::move(events.run_map);
  judged.findings = std::move(events.findings);
  judgeMotion(times, parallel, judged);
  if (judged.items == 0 && judged.events == 0 && !hasRates(times) && judged.findings.empty()) {
    judged.comparable = false;
    judged.rule = nothingJudged(judged);
    return judged;
  }
  sortByCause(judged.findings);
  addNotes(times, judged);
  const Account& left_out = judged.coverage.left_out;
  if (!left_out.empty()) judged.notes.push_back(accountSentence(left_out));
  judged.rule = runRule(judged);
  return judged;
}

}  // namespace rocinante
