#include "core/behaviour/motion_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/behaviour/run_coverage.h"

namespace rocinante {

std::int64_t RunTimes::reachOf(const RunLimits& limits) const {
  const std::int64_t resolved = spec.align == RunAlign::warp ? kWarpStep.count() : 0;
  return std::llround(limits.event_ms * 1e6) + resolved;
}

Nanoseconds RunTimes::sinceRunOrigin(std::int64_t time) const {
  return std::clamp(inRun(time), run.start, run.end) - run.origin;
}

std::string RunTimes::bothTimes(std::int64_t time) const {
  return fmt::format("{:.3f} s (accepted {:.3f} s)", secondsOf(sinceRunOrigin(time)),
                     secondsOf(sinceOrigin(time)));
}

RunFinding RunTimes::findingOfAll(RunFinding::Kind kind, std::string item) const {
  RunFinding finding;
  finding.kind = kind;
  finding.item = std::move(item);
  finding.first_accepted = finding.at_accepted = sinceOrigin(0);
  finding.until_accepted = sinceOrigin(end());
  finding.first_run = finding.at_run = sinceRunOrigin(0);
  return finding;
}

DeviceMotion::DeviceMotion(const RunTimes& times, std::string device)
    : times_(times), device_(std::move(device)) {
  const auto add = [&](const SessionTrack& track, const TimeMap& map) {
    auto& all = series_times_.emplace_back();
    const auto found = track.devices.find(device_);
    if (found == track.devices.end()) return;
    for (const TrackSeries& series : found->second.series) {
      all.push_back(alignedTimes(track, series, map, times.first().start));
    }
  };
  for (std::size_t i = 0; i < times.accepted.size(); ++i) {
    add(*times.accepted[i], times.accepted_maps[i]);
  }
  add(times.run, times.run_map);
}

ColumnOutcome DeviceMotion::judge(const TrackColumn& column,
                                  std::vector<RunFinding>& findings) const {
  const bool is_link = column.kind == TrackColumn::Kind::link_pose;
  const auto samplesOf = [&](const SessionTrack& track, std::size_t session) {
    const auto device = track.devices.find(device_);
    const TrackColumn* its =
        device == track.devices.end() ? nullptr : device->second.find(column.part, is_link);
    if (its == nullptr || its->kind != column.kind || !its->is_stated) {
      return ColumnSamples();
    }
    return ColumnSamples(track, device->second.series[its->series], *its,
                         series_times_[session][its->series]);
  };
  std::vector<ColumnSamples> accepted;
  for (std::size_t i = 0; i < times_.accepted.size(); ++i) {
    accepted.push_back(samplesOf(*times_.accepted[i], i));
  }
  const ColumnSamples run = samplesOf(times_.run, times_.accepted.size());
  return judgeColumn(times_, itemOf(device_, column), column, accepted, run, findings);
}

}  // namespace rocinante
