#include "golden/run/run_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>

#include "core/base/count_text.h"
#include "golden/run/fact_judge.h"
#include "golden/run/motion_judge.h"
#include "golden/run/motion_warp.h"
#include "golden/run/run_coverage.h"
#include "golden/run/run_events.h"

namespace rocinante {
namespace {

/// Less than this beyond the accepted end is not worth a note.
constexpr Nanoseconds kTellsOfMore = std::chrono::milliseconds(500);

std::set<std::string> namesOf(const std::vector<const SessionTrack*>& accepted,
                              const SessionTrack& run, bool of_devices) {
  std::set<std::string> names;
  const auto add = [&](const SessionTrack& track) {
    if (of_devices) {
      for (const auto& [name, device] : track.devices) names.insert(name);
    } else {
      for (const auto& [name, changes] : track.facts) names.insert(name);
    }
  };
  for (const SessionTrack* track : accepted) add(*track);
  add(run);
  return names;
}

void addNotes(const RunGrids& grids, RunJudgement& judged) {
  const SessionTrack& first = grids.first();
  const LogTime last = grids.run_grid.time(first.samples - 1);
  if (grids.run.end - last > kTellsOfMore) {
    judged.notes.push_back(
        fmt::format("the last {:.1f} s of the log are after the accepted end and were not judged",
                    secondsOf(grids.run.end - last)));
  }
  if (last - grids.run.end > kTellsOfMore) {
    judged.notes.push_back(
        fmt::format("the log ends {:.1f} s before the accepted one; its last state was held",
                    secondsOf(last - grids.run.end)));
  }
  if (grids.run.start - grids.run_grid.time(0) > kTellsOfMore) {
    judged.notes.push_back(
        fmt::format("the log begins {:.1f} s after the accepted one; its first state was held",
                    secondsOf(grids.run.start - grids.run_grid.time(0))));
  }
}

/// The sample at which packets first state a device.
std::size_t firstUpdate(const RunGrids& grids, const DeviceTrack& device) {
  const std::vector<double> before = grids.run_grid.updatesBefore(device);
  const auto found = std::ranges::upper_bound(before, 0);
  return found == before.end() ? before.size() - 1
                               : static_cast<std::size_t>(found - before.begin());
}

const DeviceTrack* statedDevice(const SessionTrack& track, const std::string& name) {
  const auto found = track.devices.find(name);
  return found != track.devices.end() && isStated(found->second) ? &found->second : nullptr;
}

RunFinding findingOfAll(const RunGrids& grids, RunFinding::Kind kind, std::string item) {
  RunFinding finding;
  finding.kind = kind;
  finding.item = std::move(item);
  finding.first_accepted = finding.at_accepted = grids.sinceOrigin(0);
  finding.until_accepted = grids.sinceOrigin(grids.run_grid.size() - 1);
  finding.first_run = finding.at_run = grids.inRun(0);
  return finding;
}

void judgeNewDevice(const RunGrids& grids, const std::string& name, const DeviceTrack& device,
                    RunJudgement& judged) {
  const std::size_t sample = firstUpdate(grids, device);
  RunFinding finding = findingOfAll(grids, RunFinding::Kind::fact, name);
  finding.first_accepted = finding.at_accepted = grids.sinceOrigin(sample);
  finding.first_run = finding.at_run = grids.inRun(sample);
  finding.what = fmt::format("{}: no accepted session has this device; here since {}", name,
                             grids.bothTimes(sample));
  judged.findings.push_back(std::move(finding));
}

/// Everything of a device that was accepted is judged no more.
void judgeLostDevice(const RunGrids& grids, const std::string& name, RunJudgement& judged) {
  const auto items = std::ranges::count_if(judged.coverage.lost, [&](const std::string& item) {
    return item == name || item.starts_with(name + "/");
  });
  if (items == 0) return;
  const std::string why = whyLeftOut(judged.coverage.left_out, name);
  RunFinding finding = findingOfAll(grids, RunFinding::Kind::coverage, name);
  finding.what =
      fmt::format("{}: not judged, since {}; {} of it {} accepted", name,
                  why.empty() ? "the session states nothing of it" : why,
                  countText(static_cast<std::size_t>(items), "item"), items == 1 ? "was" : "were");
  judged.findings.push_back(std::move(finding));
}

/// The columns that the accepted sessions have of a device, each once.
std::vector<TrackColumn> acceptedColumns(const RunGrids& grids, const std::string& name) {
  std::vector<TrackColumn> columns;
  for (const SessionTrack* track : grids.accepted) {
    const DeviceTrack* device = statedDevice(*track, name);
    if (device == nullptr) continue;
    for (const TrackColumn& column : device->columns) {
      const auto isIt = [&](const TrackColumn& other) {
        return other.part == column.part && other.kind == column.kind;
      };
      if (isStated(*device, column) && std::ranges::none_of(columns, isIt)) {
        columns.push_back(column);
      }
    }
  }
  return columns;
}

void judgeDevice(const RunGrids& grids, const std::string& name, RunJudgement& judged) {
  const DeviceTrack* own = statedDevice(grids.run, name);
  const std::vector<TrackColumn> columns = acceptedColumns(grids, name);
  if (columns.empty()) {
    if (own != nullptr && !grids.spec.isMaskedThroughout(name)) {
      judgeNewDevice(grids, name, *own, judged);
    }
    return;
  }
  if (own == nullptr) {
    judgeLostDevice(grids, name, judged);
    return;
  }
  for (const TrackColumn& column : columns) {
    const std::string item = itemOf(name, column);
    if (grids.spec.isMaskedThroughout(item)) continue;
    const bool is_link = column.kind == TrackColumn::Kind::link_pose;
    const TrackColumn* its = own->find(column.part, is_link);
    if (its == nullptr || its->kind != column.kind) {
      RunFinding finding = findingOfAll(grids, RunFinding::Kind::coverage, item);
      finding.what = fmt::format("{}: not judged, since the model has no such {}", item,
                                 is_link ? "moved link at the end of a chain" : "joint");
      if (its != nullptr) {
        finding.what = fmt::format("{}: not judged, since it is another kind of joint now", item);
      }
      judged.findings.push_back(std::move(finding));
      continue;
    }
    judged.items += judgeColumn(grids, name, column, judged.findings);
  }
  if (grids.spec.isMaskedThroughout(name)) return;
  judgeRate(grids, name, judged.findings);
  ++judged.items;
}

void judgeMotion(const RunGrids& grids, RunJudgement& judged) {
  for (const std::string& name : namesOf(grids.accepted, grids.run, true)) {
    judgeDevice(grids, name, judged);
  }
  for (const std::string& fact : namesOf(grids.accepted, grids.run, false)) {
    if (grids.spec.isMaskedThroughout(itemOfFact(fact))) continue;
    judgeFact(grids, fact, judged.findings);
    ++judged.items;
  }
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
                      const SessionTrack& run) {
  RunJudgement judged;
  const SessionTrack& first = *accepted.front();
  judged.accepted = accepted.size();
  judged.samples = first.samples;
  judged.step = first.step;
  judged.from = first.start - first.origin;
  judged.until = first.end - first.origin;
  RunEvents events = judgeEvents(spec, accepted, run);
  judged.coverage = coverageOf(spec, accepted, run);
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
  RunGrids grids{spec, accepted, run, {}, AlignedGrid(first, run, events.run_map)};
  for (std::size_t i = 0; i < accepted.size(); ++i) {
    grids.accepted_grids.emplace_back(first, *accepted[i], events.accepted_maps[i]);
  }
  judged.times = std::move(events.run_map);
  judged.findings = std::move(events.findings);
  judgeMotion(grids, judged);
  if (judged.items == 0 && judged.events == 0 && judged.findings.empty()) {
    judged.comparable = false;
    judged.rule = nothingJudged(judged);
    return judged;
  }
  std::stable_sort(judged.findings.begin(), judged.findings.end());
  addNotes(grids, judged);
  if (!run.left_out.empty()) judged.notes.push_back(accountSentence(run.left_out));
  judged.rule = runRule(judged);
  return judged;
}

}  // namespace rocinante
