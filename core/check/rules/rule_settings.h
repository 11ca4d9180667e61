#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/cell/cell.h"
#include "core/cell/cell_rules.h"
#include "core/check/rules/rule_list.h"
#include "core/report/finding.h"

namespace rocinante {

/// Thresholds of `[rules]` for devices and joints that the cell does not have. A device may still
/// be added: that is a warning.
void judgeRuleNames(const Cell& cell, Findings& findings);

/// The severity and threshold of each rule: the list of rules, as a cell's `[rules]` change it. The
/// only place where a severity is set.
class RuleSettings {
 public:
  /// The defaults of the list of rules.
  RuleSettings() = default;
  /// The defaults changed by `rules`; later entries override earlier ones.
  explicit RuleSettings(const std::vector<CellRule>& rules);

  /// Faults in `rules`: unknown ids, thresholds that a rule does not have.
  const Findings& faults() const { return faults_; }

  /// For a rule that has one.
  double threshold(std::string_view id) const;
  /// The joint's own, else its device's, else the rule's.
  double threshold(std::string_view id, std::string_view device, std::string_view joint) const;
  /// Whether the cell sets it.
  bool hasOwnThreshold(std::string_view id) const;

  /// Gives each finding its severity, and removes those of rules that are off.
  void apply(Findings& findings) const;

 private:
  std::map<std::string, CellRule, std::less<>> set_;
  Findings faults_;
};

}  // namespace rocinante
