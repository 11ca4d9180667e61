#include "viewer/ui/study/parting_study.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/behaviour/run_judge.h"
#include "core/behaviour/session_track.h"

namespace rocinante {
namespace {

/// In the shown session's time, each of one item, by time.
std::vector<Parting> partingsOf(const RunJudgement& judged, const SessionTrack& accepted,
                                const SessionTrack& run) {
  std::vector<Parting> partings;
  for (const RunFinding& finding : judged.findings) {
    const auto shown = [&](Nanoseconds moment) {
      return std::clamp(judged.times.inRun(accepted.origin + moment), run.start, run.end);
    };
    const std::string item = apartItem(finding);
    std::vector<RunSpan> spans = finding.spans;
    if (spans.empty()) spans.push_back({finding.first_accepted, finding.until_accepted});
    for (const RunSpan& span : spans) {
      partings.push_back({shown(span.from), shown(span.until), {item}});
    }
  }
  std::ranges::sort(partings, {}, &Parting::from);
  return partings;
}

std::optional<PartingPeak> largestOf(const RunJudgement& judged, const SessionTrack& run) {
  const auto largest = std::ranges::max_element(judged.findings, {}, severityOf);
  if (largest == judged.findings.end()) return std::nullopt;
  PartingPeak peak;
  peak.at = std::clamp(run.origin + largest->at_run, run.start, run.end);
  peak.item = largest->item;
  if (largest->largest) peak.size = figureText(*largest->largest, largest->unit);
  peak.what = largest->what;
  return peak;
}

/// Those that overlap as one.
std::vector<Parting> together(const std::vector<Parting>& by_item) {
  std::vector<Parting> all;
  std::set<std::string> items;
  for (const Parting& parting : by_item) {
    if (all.empty() || parting.from > all.back().until) {
      all.push_back({parting.from, parting.until, {}});
      items.clear();
    }
    all.back().until = std::max(all.back().until, parting.until);
    items.insert(parting.items.front());
    all.back().items.assign(items.begin(), items.end());
  }
  return all;
}

}  // namespace

std::string apartItem(const RunFinding& finding) {
  const bool is_whole = finding.kind == RunFinding::Kind::event ||
                        finding.kind == RunFinding::Kind::drawing ||
                        finding.item.starts_with("signal ");
  return is_whole ? finding.item : finding.item.substr(0, finding.item.find('/'));
}

PartingStudy::Answer PartingStudy::look(const Cell& cell, const Question& question,
                                        const std::stop_token& stop) {
  auto accepted = trackSession(cell, question.beside, {}, stop);
  if (!accepted.ok()) return {{}, {}, {}, accepted.error().text()};
  auto run = trackSession(cell, question.shown, {}, stop);
  if (!run.ok()) return {{}, {}, {}, run.error().text()};
  RunSpec spec;
  if (question.alignment.matched.empty()) {
    spec.align = RunAlign::origin;
    accepted->origin = question.alignment.anchor_b;
    run->origin = question.alignment.anchor_a;
  }
  const auto one_by_one = [&](std::size_t count, const std::function<void(std::size_t)>& task) {
    for (std::size_t i = 0; i < count && !stop.stop_requested(); ++i) task(i);
  };
  const RunJudgement judged = judgeRun(spec, {&*accepted}, *run, one_by_one);
  if (!judged.comparable) return {{}, {}, {}, judged.rule};
  Answer answer;
  answer.by_item = partingsOf(judged, *accepted, *run);
  answer.partings = together(answer.by_item);
  answer.largest = largestOf(judged, *run);
  return answer;
}

PartingStudy::PartingStudy(const Cell& cell, std::filesystem::path shown,
                           std::filesystem::path beside, EventAlignment alignment)
    : worker_([&cell](const Question& question, const std::stop_token& stop) {
        return look(cell, question, stop);
      }) {
  worker_.ask({std::move(shown), std::move(beside), std::move(alignment)});
}

std::vector<Parting> PartingStudy::found() const {
  const auto found = worker_.found();
  return found ? found->partings : std::vector<Parting>();
}

std::vector<std::string> PartingStudy::apartAt(LogTime moment) const {
  std::set<std::string> items;
  if (const auto found = worker_.found()) {
    for (const Parting& parting : found->by_item) {
      if (parting.from > moment) break;
      if (parting.until >= moment) items.insert(parting.items.front());
    }
  }
  return {items.begin(), items.end()};
}

std::optional<PartingPeak> PartingStudy::largest() const {
  const auto found = worker_.found();
  return found ? found->largest : std::nullopt;
}

std::string PartingStudy::fault() const {
  const auto found = worker_.found();
  return found ? found->fault : std::string();
}

std::optional<LogTime> PartingStudy::beside(LogTime moment, bool after) const {
  const std::vector<Parting> found = this->found();
  const auto next = after ? std::ranges::upper_bound(found, moment, {}, &Parting::from)
                          : std::ranges::lower_bound(found, moment, {}, &Parting::from);
  if (after) return next == found.end() ? std::nullopt : std::optional(next->from);
  return next == found.begin() ? std::nullopt : std::optional(std::prev(next)->from);
}

}  // namespace rocinante
