#include "core/check/rules/rule_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
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

std::string ruleHint(std::string_view id) {
  std::vector<std::string_view> ids;
  for (const Rule& rule : allRules()) ids.push_back(rule.id);
  return didYouMean(id, ids);
}

std::string thresholdHint(const Rule& rule) {
  return rule.threshold.key.empty() ? "it has none"
                                    : fmt::format("it has `{}`", rule.threshold.key);
}

/// Drops, with a fault, thresholds of devices and joints that the rule does not have.
void takeOwn(const Rule& rule, FaultList& faults, Place place, CellRule& setting) {
  const bool judges_joints = setting.id.starts_with("joint.") && !rule.threshold.key.empty();
  std::erase_if(setting.own_thresholds, [&](const auto& own) {
    if (judges_joints && own.second.key == rule.threshold.key) return false;
    faults.error("cell.rule-threshold", place,
                 fmt::format("{} of {} has no threshold {}", setting.id, quotedInFault(own.first),
                             quotedInFault(own.second.key)),
                 judges_joints ? thresholdHint(rule) : "only rules of joints have such tables");
    return true;
  });
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

RuleSettings::RuleSettings(const std::vector<CellRule>& rules) {
  std::map<std::string, FaultList> faults_of_file;
  for (const CellRule& setting : rules) {
    FaultList& faults =
        faults_of_file.try_emplace(setting.file, faults_, setting.file).first->second;
    const Place place{setting.line, setting.column};
    const Rule* const rule = findRule(setting.id);
    if (rule == nullptr) {
      faults.error("cell.unknown-rule", place,
                   fmt::format("there is no rule {}", quotedInFault(setting.id)),
                   ruleHint(setting.id));
      continue;
    }
    CellRule& mine = set_[setting.id];
    CellRule before = std::exchange(mine, setting);
    takeOwn(*rule, faults, place, mine);
    mine.own_thresholds.merge(before.own_thresholds);
    if (setting.threshold_key.empty()) {
      mine.threshold_key = before.threshold_key;
      mine.threshold = before.threshold;
    } else if (setting.threshold_key != rule->threshold.key) {
      faults.error(
          "cell.rule-threshold", place,
          fmt::format("{} has no threshold {}", setting.id, quotedInFault(setting.threshold_key)),
          thresholdHint(*rule));
      mine.threshold_key.clear();
    }
  }
}

double RuleSettings::threshold(std::string_view id) const {
  if (hasOwnThreshold(id)) return set_.find(id)->second.threshold;
  const Rule* const rule = findRule(id);
  assert(rule != nullptr && !rule->threshold.key.empty());
  return rule->threshold.value;
}

double RuleSettings::threshold(std::string_view id, std::string_view device,
                               std::string_view joint) const {
  const auto found = set_.find(id);
  if (found != set_.end() && !found->second.own_thresholds.empty()) {
    const auto& own = found->second.own_thresholds;
    for (const std::string& of : {fmt::format("{}/{}", device, joint), std::string(device)}) {
      if (const auto named = own.find(of); named != own.end()) return named->second.value;
    }
  }
  return threshold(id);
}

bool RuleSettings::hasOwnThreshold(std::string_view id) const {
  const auto found = set_.find(id);
  return found != set_.end() && !found->second.threshold_key.empty();
}

void RuleSettings::apply(Findings& findings) const {
  if (set_.empty()) return;
  std::erase_if(findings, [&](const Finding& finding) {
    const auto found = set_.find(finding.rule);
    return found != set_.end() && found->second.is_off;
  });
  for (Finding& finding : findings) {
    const auto found = set_.find(finding.rule);
    if (found != set_.end() && found->second.severity) finding.severity = *found->second.severity;
  }
}

}  // namespace rocinante
