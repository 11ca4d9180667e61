#pragma once

#include <span>
#include <string_view>

#include "core/report/finding.h"

namespace rocinante {

/// The threshold of a rule, where it has one. A cell may set another in `[rules]`.
struct RuleThreshold {
  std::string_view key;  ///< as the cell writes it, named after its unit: "ms"
  double value = 0;      ///< where the cell says nothing
};

/// A rule of `check`.
struct Rule {
  std::string_view id;  ///< stable: scripts, cells and baselines name it
  Severity severity;    ///< where the cell says nothing, and a model's reader no other
  std::string_view title;
  RuleThreshold threshold{};  ///< an empty key: none
};

/// Every rule that a finding can carry, sorted by id. docs/rules/FAMILY.md explains it.
std::span<const Rule> allRules();

/// Null when there is no rule of that id.
const Rule* findRule(std::string_view id);

/// What it finds is wrong in a file of a mesh, and so in pictures alone: links and joints move all
/// the same.
bool isOfPicturesOnly(std::string_view id);

}  // namespace rocinante
