#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/figure_text.h"
#include "core/behaviour/motion_judge.h"
#include "core/behaviour/run_coverage.h"
#include "core/behaviour/unfit_values.h"

namespace rocinante {
namespace {

std::set<std::string> devicesOf(const RunTimes& times) {
  std::set<std::string> names;
  times.eachSession([&](const SessionTrack& track) {
    for (const auto& [name, device] : track.devices) names.insert(name);
  });
  return names;
}

/// When packets first state a device.
std::int64_t firstUpdate(const RunTimes& times, const DeviceTrack& device) {
  const auto found = std::ranges::find_if(device.updates, [](auto count) { return count > 0; });
  return times.onLine(times.run.start + kCountBin * (found - device.updates.begin()));
}

const DeviceTrack* statedDevice(const SessionTrack& track, const std::string& name) {
  const auto found = track.devices.find(name);
  return found != track.devices.end() && isStated(found->second) ? &found->second : nullptr;
}

void judgeNewDevice(const RunTimes& times, const std::string& name, const DeviceTrack& device,
                    RunJudgement& judged) {
  const std::int64_t time = firstUpdate(times, device);
  RunFinding finding = times.findingOfAll(RunFinding::Kind::fact, name);
  finding.first_accepted = finding.at_accepted = times.sinceOrigin(time);
  finding.first_run = finding.at_run = times.sinceRunOrigin(time);
  finding.what = fmt::format("{}: no accepted session has this device; here since {}", name,
                             times.bothTimes(time));
  judged.findings.push_back(std::move(finding));
}

/// Devices of the cell that some session states, and whose model is not there: nobody knows whether
/// they are as accepted.
void judgeUnread(const RunTimes& times, RunJudgement& judged) {
  std::set<std::string> names;
  times.eachSession([&](const SessionTrack& track) {
    for (const LeftOut& item : track.left_out.leftOut()) {
      if (item.kind == kUnreadModel) names.insert(item.name);
    }
  });
  for (const std::string& name : names) {
    const auto isIt = [&](const RunFinding& finding) { return finding.item == name; };
    if (times.spec.isMaskedThroughout(name) || std::ranges::any_of(judged.findings, isIt)) continue;
    RunFinding finding = times.findingOfAll(RunFinding::Kind::coverage, name);
    finding.what = fmt::format("{}: not judged, since its model could not be read", name);
    judged.findings.push_back(std::move(finding));
  }
}

/// Everything of a device that was accepted is judged no more.
void judgeLostDevice(const RunTimes& times, const std::string& name, RunJudgement& judged) {
  const auto items = std::ranges::count_if(judged.coverage.lost, [&](const std::string& item) {
    return item == name || item.starts_with(name + "/");
  });
  if (items == 0) return;
  const std::string why = whyLeftOut(judged.coverage.left_out, name);
  RunFinding finding = times.findingOfAll(RunFinding::Kind::coverage, name);
  finding.what =
      fmt::format("{}: not judged, since {}; {} of it {} accepted", name,
                  why.empty() ? "the session states nothing of it" : why,
                  countText(static_cast<std::size_t>(items), "item"), items == 1 ? "was" : "were");
  judged.findings.push_back(std::move(finding));
}

/// The columns that the accepted sessions have of a device, each once.
std::vector<TrackColumn> acceptedColumns(const RunTimes& times, const std::string& name) {
  std::vector<TrackColumn> columns;
  for (const SessionTrack* track : times.accepted) {
    const DeviceTrack* device = statedDevice(*track, name);
    if (device == nullptr) continue;
    for (const TrackColumn& column : device->columns) {
      const auto isIt = [&](const TrackColumn& other) {
        return other.part == column.part && other.kind == column.kind;
      };
      if (column.is_stated && std::ranges::none_of(columns, isIt)) {
        columns.push_back(column);
      }
    }
  }
  return columns;
}

/// A device that all sides have.
struct DeviceToJudge {
  /// What is found of it, in the order of its columns: where a column cannot be judged, why.
  struct Item {
    TrackColumn column;
    bool is_judged = true;
    std::vector<RunFinding> findings;
    ColumnOutcome outcome;
  };
  std::string name;
  std::vector<Item> items;
  std::uint64_t rows = 0;
};

/// Some accepted session does without the value.
bool mayBeAbsent(const RunTimes& times, const std::string& name, const TrackColumn& column) {
  return std::ranges::any_of(times.accepted, [&](const SessionTrack* track) {
    const DeviceTrack* device = statedDevice(*track, name);
    if (device == nullptr) return true;
    const bool is_link = column.kind == TrackColumn::Kind::link_pose;
    const TrackColumn* its = device->find(column.part, is_link);
    return its == nullptr || !its->is_stated;
  });
}

std::vector<DeviceToJudge::Item> itemsToJudge(const RunTimes& times, const std::string& name,
                                              const DeviceTrack& own,
                                              const std::vector<TrackColumn>& columns,
                                              const Account& left_out) {
  std::vector<DeviceToJudge::Item> items;
  for (const TrackColumn& column : columns) {
    const std::string item = itemOf(name, column);
    if (times.spec.isMaskedThroughout(item)) continue;
    const bool is_link = column.kind == TrackColumn::Kind::link_pose;
    const TrackColumn* its = own.find(column.part, is_link);
    DeviceToJudge::Item& to_judge = items.emplace_back();
    to_judge.column = column;
    if (its != nullptr && its->kind == column.kind && its->is_stated) continue;
    to_judge.is_judged = false;
    if (its != nullptr && !its->is_stated && mayBeAbsent(times, name, column)) continue;
    RunFinding finding = times.findingOfAll(RunFinding::Kind::coverage, item);
    if (its != nullptr && its->kind == column.kind) {
      const std::string why = whyLeftOut(left_out, name);
      finding.what = fmt::format("{}: not judged, since {}", item,
                                 why.empty() ? "the session states no value of it" : why);
      to_judge.findings.push_back(std::move(finding));
      continue;
    }
    finding.what = fmt::format("{}: not judged, since the model has no such {}", item,
                               is_link ? "link that moves" : "joint");
    if (its != nullptr) {
      finding.what = fmt::format("{}: not judged, since it is another kind of joint now", item);
    }
    to_judge.findings.push_back(std::move(finding));
  }
  return items;
}

/// Values that the run states and no accepted session does.
void judgeNewColumns(const RunTimes& times, const std::string& name, const DeviceTrack& own,
                     const std::vector<TrackColumn>& accepted, RunJudgement& judged) {
  for (const TrackColumn& column : own.columns) {
    const std::string item = itemOf(name, column);
    const auto isIt = [&](const TrackColumn& other) {
      return other.part == column.part && other.kind != TrackColumn::Kind::link_pose;
    };
    if (!column.is_stated || column.kind == TrackColumn::Kind::link_pose ||
        std::ranges::any_of(accepted, isIt) || times.spec.isMaskedThroughout(item)) {
      continue;
    }
    RunFinding finding = times.findingOfAll(RunFinding::Kind::fact, item);
    finding.what = fmt::format("{}: no accepted session states {}; this one does", item,
                               column.part.empty() ? "its pose" : "this value");
    judged.findings.push_back(std::move(finding));
  }
}

std::uint64_t rowsOf(const RunTimes& times, const std::string& name) {
  std::uint64_t rows = 0;
  times.eachSession([&](const SessionTrack& track) {
    const auto found = track.devices.find(name);
    if (found == track.devices.end()) return;
    for (const TrackSeries& series : found->second.series) rows += series.rows;
  });
  return rows;
}

/// The devices that can be judged; findings of devices that cannot be are added to `judged`.
std::vector<DeviceToJudge> devicesToJudge(const RunTimes& times, RunJudgement& judged) {
  std::vector<DeviceToJudge> devices;
  for (const std::string& name : devicesOf(times)) {
    const DeviceTrack* own = statedDevice(times.run, name);
    const std::vector<TrackColumn> columns = acceptedColumns(times, name);
    if (columns.empty()) {
      if (own != nullptr && !times.spec.isMaskedThroughout(name)) {
        judgeNewDevice(times, name, *own, judged);
      }
    } else if (own == nullptr) {
      judgeLostDevice(times, name, judged);
    } else {
      judgeNewColumns(times, name, *own, columns, judged);
      devices.push_back({name, itemsToJudge(times, name, *own, columns, judged.coverage.left_out),
                         rowsOf(times, name)});
    }
  }
  judgeUnread(times, judged);
  return devices;
}

void judgeTogether(const RunTimes& times, const ParallelFor& parallel,
                   std::span<DeviceToJudge> devices) {
  std::vector<std::optional<DeviceMotion>> motions(devices.size());
  forEachIndex(parallel, devices.size(),
               [&](std::size_t i) { motions[i].emplace(times, devices[i].name); });
  std::vector<std::pair<const DeviceMotion*, DeviceToJudge::Item*>> all;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    if (!motions[i]) continue;  // given up
    for (DeviceToJudge::Item& item : devices[i].items) {
      if (item.is_judged) all.emplace_back(&*motions[i], &item);
    }
  }
  forEachIndex(parallel, all.size(), [&](std::size_t i) {
    const auto& [motion, item] = all[i];
    item->outcome = motion->judge(item->column, item->findings);
  });
}

}  // namespace

FastMotion judgeDevices(const RunTimes& times, const ParallelFor& parallel, RunJudgement& judged,
                        std::uint64_t batch_rows) {
  std::vector<DeviceToJudge> devices = devicesToJudge(times, judged);
  for (auto from = devices.begin(); from != devices.end();) {
    std::uint64_t rows = 0;
    const auto until = std::find_if(from, devices.end(), [&](const DeviceToJudge& device) {
      return std::exchange(rows, rows + device.rows) > batch_rows;
    });
    judgeTogether(times, parallel, std::span(from, until));
    from = until;
  }
  FastMotion fastest;
  for (DeviceToJudge& device : devices) {
    for (DeviceToJudge::Item& item : device.items) {
      std::ranges::move(item.findings, std::back_inserter(judged.findings));
      judged.values += item.outcome.values;
      if (item.outcome.fastest.times_limit > fastest.times_limit) {
        fastest = std::move(item.outcome.fastest);
      }
    }
    if (times.spec.isMaskedThroughout(device.name)) continue;
    judgeRate(times, device.name, judged.findings);
  }
  return fastest;
}

}  // namespace rocinante
