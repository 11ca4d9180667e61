#include "core/check/judges/source_clocks.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace rocinante {

ClockJudge& SourceClocks::clockOf(std::string_view publisher) {
  if (publisher.empty()) return own_;
  auto found = others_.find(publisher);
  if (found == others_.end()) {
    if (others_.size() == kMaxPublishers) return own_;
    found = others_.emplace(std::string(publisher), ClockJudge(thresholds_)).first;
    if (is_ignored_) found->second.ignore();
  }
  return found->second;
}

void SourceClocks::report(const std::string& source, Findings& findings) const {
  Findings found;
  own_.report(source, found);
  for (const auto& [publisher, clock] : others_) {
    Findings its;
    clock.report(source, its);
    for (Finding& finding : its) {
      if (finding.rule == "source.clock-step") {
        finding.text += ", in what is sent of " + publisher;
      } else if (std::ranges::find(found, finding.rule, &Finding::rule) != found.end()) {
        continue;
      }
      found.push_back(std::move(finding));
    }
  }
  std::ranges::move(found, std::back_inserter(findings));
}

}  // namespace rocinante
