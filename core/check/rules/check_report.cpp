#include "core/check/rules/check_report.h"

#include <algorithm>
#include <tuple>

namespace rocinante {

std::string_view nameOf(CheckVerdict verdict) {
  switch (verdict) {
    case CheckVerdict::compatible:
      return "compatible";
    case CheckVerdict::incompatible:
      return "incompatible";
    case CheckVerdict::nothing_judged:
      return "nothing_judged";
    case CheckVerdict::interrupted:
      return "interrupted";
  }
  return "";
}

std::size_t CheckReport::countOf(Severity severity) const {
  return static_cast<std::size_t>(std::count_if(
      findings.begin(), findings.end(),
      [&](const Finding& finding) { return finding.severity == severity && !finding.accepted; }));
}

std::size_t CheckReport::countOfAccepted() const {
  return static_cast<std::size_t>(std::count_if(
      findings.begin(), findings.end(), [](const Finding& finding) { return finding.accepted; }));
}

void conclude(CheckReport& report) {
  report.rules.apply(report.findings);
  const auto key = [](const Finding& f) {
    // Errors first; model faults before session faults.
    return std::tuple(-static_cast<int>(f.severity), f.first.has_value(),
                      f.first.value_or(LogTime{}), std::string_view(f.file), f.line, f.column,
                      std::string_view(f.rule), std::string_view(f.subject),
                      std::string_view(f.text));
  };
  std::sort(report.findings.begin(), report.findings.end(),
            [&](const Finding& a, const Finding& b) { return key(a) < key(b); });
  const bool failed = std::any_of(report.findings.begin(), report.findings.end(),
                                  [&](const Finding& f) { return report.isFailure(f); });
  if (report.interrupted) {
    report.verdict = CheckVerdict::interrupted;
  } else if (report.has_session && report.packets == 0) {
    report.verdict = CheckVerdict::nothing_judged;
  } else {
    report.verdict = failed ? CheckVerdict::incompatible : CheckVerdict::compatible;
  }
}

}  // namespace rocinante
