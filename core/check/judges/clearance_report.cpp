#include "core/check/judges/clearance_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/check/judges/tally.h"
#include "core/clearance/clearance_gauge.h"

namespace rocinante {
namespace {

std::array<double, 3> roundedPoint(const Vec3& point) {
  const auto each = [](double value) { return std::floor(value * 1e5 + 0.5) / 1e5; };
  return {each(point.x), each(point.y), each(point.z)};
}

CheckedClearance checkedOf(const ClearanceOutcome& outcome, const std::string& name) {
  CheckedClearance checked;
  checked.name = name;
  checked.device_a = outcome.device_a;
  checked.device_b = outcome.device_b;
  checked.min_m = outcome.min_m;
  checked.least_m = roundedClearance(outcome.least.distance_m);
  checked.link_a = outcome.least.link_a;
  checked.link_b = outcome.least.link_b;
  checked.on_a = roundedPoint(outcome.least.on_a);
  checked.on_b = roundedPoint(outcome.least.on_b);
  checked.at = outcome.least.time;
  checked.violations = outcome.violations;
  for (const ClearanceSpan& span : outcome.spans) {
    checked.spans.push_back({span.from, span.until, roundedClearance(span.least_m)});
  }
  return checked;
}

Finding findingOf(const ClearanceOutcome& outcome) {
  const LeastClearance& least = outcome.least;
  const bool penetrates = !(least.distance_m > 0);
  Finding finding = penetrates
                        ? makeFinding("clearance.penetrating", outcome.device_a,
                                      fmt::format("{} penetrates {}", least.link_a, least.link_b))
                        : makeFinding("clearance.too-close", outcome.device_a,
                                      fmt::format("{} comes within {} of {}, where {} are required",
                                                  least.link_a, millimetres(least.distance_m),
                                                  least.link_b, millimetres(outcome.min_m)));
  // In hundredths of a millimetre, as the sentence has it: the nearer, the worse.
  if (!penetrates) finding.worst = -std::round(roundedClearance(least.distance_m) * 1e5) / 100;
  finding.count = outcome.violations;
  finding.first = outcome.spans.front().from;
  finding.last = outcome.last_violation;
  finding.when = outcome.when;
  return finding;
}

}  // namespace

std::string millimetres(double metres) {
  return fmt::format("{:.2f} mm", roundedClearance(metres) * 1e3);
}

void reportClearances(const Cell& cell, const ClearanceJudge& judge,
                      std::vector<CheckedClearance>& clearances, Findings& findings) {
  std::vector<const ClearanceOutcome*> outcomes;
  for (const ClearanceOutcome& outcome : judge.outcomes()) outcomes.push_back(&outcome);
  std::ranges::stable_sort(outcomes, {}, &ClearanceOutcome::clearance);
  for (const ClearanceOutcome* outcome : outcomes) {
    clearances.push_back(checkedOf(*outcome, cell.clearances[outcome->clearance].name));
    if (outcome->violations > 0) findings.push_back(findingOf(*outcome));
  }
  // A session without a packet is said to be unjudged as a whole.
  if (!judge.hasBegun()) return;
  for (const std::size_t i : judge.unjudged()) {
    const CellClearance& clearance = cell.clearances[i];
    findings.push_back(makeFinding(
        "clearance.unjudged", clearance.name,
        fmt::format("no two links with geometry are those of the clearance `{}`", clearance.name)));
    findings.back().hint = clearance.is_self
                               ? "links that one joint joins are not judged against each other"
                               : "`rocinante model tree` lists devices and links";
  }
  if (judge.hadTooMany()) {
    findings.push_back(makeFinding(
        "clearance.unjudged", "",
        fmt::format("the clearances name more than {} pairs of links: the rest is not judged",
                    kMaxClearancePairs)));
  }
}

}  // namespace rocinante
