#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/check/rules/rule_list.h"
#include "core/report/finding.h"

namespace rocinante {

/// Collects the drift of one subject: a device, or a model that only `add` can bring.
class DriftList {
 public:
  DriftList(Findings& findings, std::string subject)
      : findings_(findings), subject_(std::move(subject)) {}

  const std::string& subject() const { return subject_; }

  void add(std::string_view rule, std::string text, std::string hint = {}) {
    Finding finding;
    finding.rule = rule;
    if (const Rule* const known = findRule(rule)) finding.severity = known->severity;
    finding.subject = subject_;
    finding.text = std::move(text);
    finding.hint = std::move(hint);
    findings_.push_back(std::move(finding));
  }

 private:
  Findings& findings_;
  std::string subject_;
};

}  // namespace rocinante
