#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/cell/cell_rules.h"
#include "core/check/rules/rule_list.h"

namespace rocinante {

struct Finding;

/// How severe each rule is, and what it measures against: the list of rules, as a cell's `[rules]`
/// change it. The one place where a severity is set.
class RuleSettings {
 public:
  /// As the list of rules says.
  RuleSettings() = default;
  /// As `rules` change it, the later ones over the earlier.
  explicit RuleSettings(const std::vector<CellRule>& rules);

  /// What `rules` say that there is not: unknown ids, thresholds that a rule does not have.
  const ModelFaults& faults() const { return faults_; }

  /// Of a rule that has one.
  double threshold(std::string_view id) const;
  /// Whether the cell gave it.
  bool hasOwnThreshold(std::string_view id) const;

  /// Gives each finding its severity, and removes those of rules that are off.
  void apply(std::vector<Finding>& findings) const;

 private:
  std::map<std::string, CellRule, std::less<>> set_;
  ModelFaults faults_;
};

}  // namespace rocinante
