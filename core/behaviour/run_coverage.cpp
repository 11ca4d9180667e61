#include "core/behaviour/run_coverage.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <initializer_list>
#include <map>
#include <utility>

#include "core/base/name_hint.h"
#include "core/base/pattern.h"
#include "core/base/plain_text.h"
#include "core/behaviour/session_track.h"

namespace rocinante {
namespace {

bool isOfDevice(const LeftOut& left_out, std::string_view device) {
  return left_out.name == device ||
         (left_out.name.starts_with(device) && left_out.name[device.size()] == '/');
}

/// The joint values, poses and numbers that a session states. A fact may have the name of a pose.
std::set<std::string> motionsOf(const SessionTrack& track) {
  std::set<std::string> items;
  for (const auto& [name, device] : track.devices) {
    for (const TrackColumn& column : device.columns) {
      if (column.is_stated) items.insert(itemOf(name, column));
    }
  }
  for (const auto& [item, series] : track.numbers) items.insert(item);
  return items;
}

/// What a mask or a limit may name besides what sessions state.
std::set<std::string> namesOf(const Cell& cell) {
  std::set<std::string> names;
  for (const CellDevice& device : cell.devices) {
    names.insert(device.name);
    const Model* model = cell.modelOf(device);
    if (model == nullptr) continue;
    for (const TrackColumn& column : columnsOf(*model)) names.insert(itemOf(device.name, column));
    for (const Link& link : model->links) names.insert(device.name + "/" + link.name);
  }
  return names;
}

using LimitKeys = std::set<std::string_view>;

void addKeys(LimitKeys& keys, std::initializer_list<std::string_view> more) { keys.insert(more); }

/// By DEVICE, DEVICE/JOINT and DEVICE/LINK.
std::map<std::string, LimitKeys> limitKeysOf(const Cell& cell) {
  std::map<std::string, LimitKeys> keys;
  for (const CellDevice& device : cell.devices) {
    LimitKeys& of_device = keys[device.name];
    addKeys(of_device, {"position_mm", "turn_deg", "pose_mm", "pose_deg"});
    const Model* const model = cell.modelOf(device);
    if (model == nullptr) continue;
    for (const TrackColumn& column : columnsOf(*model)) {
      if (column.kind >= TrackColumn::Kind::pose) continue;
      const std::string_view key =
          column.kind == TrackColumn::Kind::length ? "position_mm" : "joint_deg";
      of_device.insert(key);
      keys[itemOf(device.name, column)].insert(key);
    }
    for (const Link& link : model->links) {
      addKeys(keys[device.name + "/" + link.name], {"position_mm", "turn_deg"});
    }
  }
  return keys;
}

/// Those that are written.
LimitKeys writtenKeys(const OwnLimits& limits) {
  LimitKeys keys;
  for (const auto& [key, limit] :
       {std::pair("joint_deg", limits.joint_deg), std::pair("position_mm", limits.position_mm),
        std::pair("turn_deg", limits.turn_deg), std::pair("pose_mm", limits.pose_mm),
        std::pair("pose_deg", limits.pose_deg), std::pair("signal", limits.signal),
        std::pair("signal_share", limits.signal_share)}) {
    if (limit) keys.insert(key);
  }
  return keys;
}

}  // namespace

std::string itemOf(std::string_view device, const TrackColumn& column) {
  std::string item(device);
  if (!column.part.empty()) item += "/" + column.part;
  return item;
}

std::string itemOf(const Event& event) { return "event/" + event.text; }

std::string itemOfFact(std::string_view fact) {
  if (fact.starts_with("drawing/")) return std::string(fact.substr(0, fact.find('\t')));
  const std::size_t of = fact.find(" of ");
  return std::string(of == std::string_view::npos ? fact : fact.substr(of + 4));
}

std::string unitFact(std::string_view signal) { return "unit of " + std::string(signal); }

bool isStated(const DeviceTrack& device) {
  return std::ranges::any_of(device.columns, &TrackColumn::is_stated);
}

std::set<std::string> itemsOf(const SessionTrack& track) {
  std::set<std::string> items = motionsOf(track);
  for (const auto& [fact, changes] : track.facts) items.insert(itemOfFact(fact));
  for (const Event& event : track.events) items.insert(itemOf(event));
  return items;
}

RunCoverage coverageOf(const RunSpec& spec, const std::vector<const SessionTrack*>& accepted,
                       const SessionTrack& run) {
  RunCoverage coverage;
  std::set<std::string> all;
  // Of events and facts the absence is judged; what some accepted session lacks may be absent.
  std::set<std::string> moved;
  std::set<std::string> needed = motionsOf(*accepted.front());
  for (const SessionTrack* track : accepted) {
    all.merge(itemsOf(*track));
    const std::set<std::string> its = motionsOf(*track);
    std::erase_if(needed, [&](const std::string& item) { return !its.contains(item); });
    moved.insert(its.begin(), its.end());
  }
  const std::set<std::string> now = motionsOf(run);
  for (const std::string& item : all) {
    if (spec.isMaskedThroughout(item)) {
      coverage.masked.insert(item);
    } else if (now.contains(item) || !moved.contains(item)) {
      coverage.judged.insert(item);
    } else if (needed.contains(item)) {
      coverage.lost.insert(item);
    }
  }
  coverage.left_out = run.left_out;
  return coverage;
}

std::string whyLeftOut(const Account& left_out, std::string_view device) {
  for (const LeftOut& item : left_out.leftOut()) {
    if (isOfDevice(item, device)) return item.reason;
  }
  return {};
}

std::vector<std::string> namesThatMatchNothing(const RunSpec& spec, const Cell& cell,
                                               const std::set<std::string>& items) {
  std::set<std::string> known = namesOf(cell);
  known.insert(items.begin(), items.end());
  for (const std::string& item : items) known.emplace(deviceOfItem(item));
  const std::vector<std::string_view> names(known.begin(), known.end());
  std::vector<std::string> complaints;
  const auto complain = [&](const char* key, const std::string& name) {
    const std::string hint = didYouMean(name, names);
    complaints.push_back(fmt::format("{} `{}` matches nothing in the cell or in any session{}", key,
                                     plainText(name), hint.empty() ? "" : " (" + hint + ")"));
  };
  for (const RunMask& mask : spec.masks) {
    const auto matches = [&](std::string_view name) { return patternMatches(mask.item, name); };
    if (std::ranges::none_of(names, matches)) complain("mask", mask.item);
  }
  for (const auto& [name, limits] : spec.own_limits) {
    if (!known.contains(name)) complain("limits of", name);
  }
  return complaints;
}

std::vector<std::string> limitsThatNothingTakes(const RunSpec& spec, const Cell& cell,
                                                const std::set<std::string>& items,
                                                const std::set<std::string>& numbers) {
  std::map<std::string, LimitKeys> known = limitKeysOf(cell);
  for (const std::string& item : items) {
    const bool is_drawing = item.starts_with("drawing/"), is_signal = item.starts_with("signal ");
    // What else a session states is of its devices.
    if (!is_drawing && !is_signal && !item.starts_with("event/")) continue;
    for (const std::string& name : {item, deviceOfItem(item)}) {
      LimitKeys& keys = known[name];
      if (is_drawing) keys.insert("position_mm");
      if (numbers.contains(item)) keys.insert("signal_share");
    }
    if (numbers.contains(item)) known[item].insert("signal");
  }
  std::vector<std::string> complaints;
  for (const auto& [name, limits] : spec.own_limits) {
    const auto found = known.find(name);
    if (found == known.end()) continue;
    // How much earlier or later it may come holds of everything.
    found->second.insert("event_ms");
    LimitKeys idle = writtenKeys(limits);
    std::erase_if(idle, [&](std::string_view key) { return found->second.contains(key); });
    if (idle.empty()) continue;
    complaints.push_back(fmt::format("limits of `{}`: nothing takes its {}; it takes {}",
                                     plainText(name), fmt::join(idle, ", "),
                                     fmt::join(found->second, ", ")));
  }
  return complaints;
}

}  // namespace rocinante
