#include "core/behaviour/run_coverage.h"

#include <fmt/format.h>

#include <algorithm>

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

}  // namespace rocinante
