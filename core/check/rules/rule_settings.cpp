#include "core/check/rules/rule_settings.h"

#include <fmt/format.h>

#include <cassert>
#include <utility>

#include "core/base/name_hint.h"
#include "core/document/fault_list.h"

namespace rocinante {
namespace {

std::string ruleHint(std::string_view id) {
  std::vector<std::string_view> ids;
  for (const Rule& rule : allRules()) ids.push_back(rule.id);
  return didYouMean(id, ids);
}

std::string thresholdHint(const Rule& rule) {
  return rule.threshold.key.empty() ? "it has none"
                                    : fmt::format("it has `{}`", rule.threshold.key);
}

}  // namespace

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
    const CellRule before = std::exchange(mine, setting);
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
