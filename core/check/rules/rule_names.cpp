#include "core/check/rules/rule_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/name_hint.h"
#include "core/document/fault_list.h"

namespace rocinante {
namespace {

using ModelsByDevice = std::map<std::string_view, const Model*>;

ModelsByDevice modelsByDevice(const Cell& cell) {
  ModelsByDevice models;
  for (const CellDevice& device : cell.devices) models.emplace(device.name, cell.modelOf(device));
  for (const CellSource& source : cell.sources) {
    for (const auto& [ghost, original] : source.ghost_of) {
      const CellDevice* const device = cell.findDevice(original);
      if (device != nullptr) models.emplace(ghost, cell.modelOf(*device));
    }
  }
  return models;
}

/// Names of the joints that a session can drive.
std::vector<std::string_view> drivenJoints(const Model& model) {
  std::vector<std::string_view> names;
  for (const std::size_t joint : model.movableJoints()) names.push_back(model.joints[joint].name);
  return names;
}

}  // namespace

void judgeRuleNames(const Cell& cell, Findings& findings) {
  const auto has_own = [](const CellRule& rule) { return !rule.own_thresholds.empty(); };
  if (std::ranges::none_of(cell.rules, has_own)) return;
  const ModelsByDevice models = modelsByDevice(cell);
  std::map<const Model*, std::set<std::string_view>> joints;
  for (const CellRule& rule : cell.rules) {
    FaultList faults(findings, rule.file);
    const Place place{rule.line, rule.column};
    for (const auto& [name, threshold] : rule.own_thresholds) {
      const std::string_view whole = name;
      const std::size_t slash = whole.find('/');
      const auto device = models.find(whole.substr(0, slash));
      if (device == models.end()) {
        std::vector<std::string_view> known;
        for (const auto& [each, model] : models) known.push_back(each);
        faults.warning("cell.unknown-device", place,
                       fmt::format("{} names {}, which the cell does not have", rule.id,
                                   quotedInFault(whole.substr(0, slash))),
                       didYouMean(whole.substr(0, slash), known));
        continue;
      }
      const Model* const model = device->second;
      if (slash == whole.npos || model == nullptr) continue;
      const auto [driven, is_new] = joints.try_emplace(model);
      if (is_new) {
        const auto names = drivenJoints(*model);
        driven->second.insert(names.begin(), names.end());
      }
      const std::string_view joint = whole.substr(slash + 1);
      if (driven->second.contains(joint)) continue;
      faults.error("cell.rule-threshold", place,
                   fmt::format("{} has a threshold of {}, which is no driven joint of the cell",
                               rule.id, quotedInFault(name)),
                   didYouMean(joint, drivenJoints(*model)));
    }
  }
}

}  // namespace rocinante
