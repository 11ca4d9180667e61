#include "golden/run/run_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>

#include "core/base/count_text.h"
#include "golden/run/fact_judge.h"
#include "golden/run/motion_judge.h"
#include "golden/run/motion_warp.h"
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

void judgeMotion(const RunGrids& grids, RunJudgement& judged) {
  for (const std::string& name : namesOf(grids.accepted, grids.run, true)) {
    const auto found = grids.first().devices.find(name);
    const DeviceTrack* device = found != grids.first().devices.end() ? &found->second : nullptr;
    if (device == nullptr) {
      const bool is_accepted = std::ranges::any_of(
          grids.accepted, [&](const SessionTrack* track) { return track->devices.contains(name); });
      if (is_accepted || grids.spec.isMasked(name, Nanoseconds(0))) continue;
      RunFinding finding;
      finding.kind = RunFinding::Kind::fact;
      finding.item = name;
      const std::size_t sample = firstUpdate(grids, grids.run.devices.find(name)->second);
      finding.first_accepted = finding.at_accepted = grids.sinceOrigin(sample);
      finding.until_accepted = grids.sinceOrigin(grids.run_grid.size() - 1);
      finding.first_run = finding.at_run = grids.inRun(sample);
      finding.what = fmt::format("{}: no accepted session has this device; here since {}", name,
                                 grids.bothTimes(sample));
      judged.findings.push_back(std::move(finding));
      continue;
    }
    for (const TrackColumn& column : device->columns) {
      judged.items += judgeColumn(grids, name, column, judged.findings);
    }
    judgeRate(grids, name, judged.findings);
    ++judged.items;
  }
  for (const std::string& fact : namesOf(grids.accepted, grids.run, false)) {
    judgeFact(grids, fact, judged.findings);
    ++judged.items;
  }
}

std::string ruleOf(const RunJudgement& judged) {
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

}  // namespace

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
  judged.events = first.events.size();
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
  std::stable_sort(judged.findings.begin(), judged.findings.end());
  addNotes(grids, judged);
  judged.rule = ruleOf(judged);
  return judged;
}

}  // namespace rocinante
