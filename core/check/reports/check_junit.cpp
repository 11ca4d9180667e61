#include <fmt/format.h>

#include <map>

#include "core/base/plain_text.h"
#include "core/check/reports/report_formats.h"
#include "core/check/rules/rule_list.h"

namespace rocinante {
namespace {

std::string paragraphOf(const CheckReport& report, const Finding& finding) {
  const std::string place = placeText(finding);
  std::string text = fmt::format("{}: {}{}{}\n", nameOf(finding.severity), place,
                                 place.empty() ? "" : ": ", finding.text);
  if (finding.first) text += "  " + whenText(report, finding) + "\n";
  if (!finding.example.empty()) text += "  such as: " + finding.example + "\n";
  if (!finding.hint.empty()) text += "  hint: " + finding.hint + "\n";
  return text;
}

struct Counts {
  std::size_t tests = 0, failures = 0, errors = 0, skipped = 0;
};

/// The test case of one rule, with its findings.
std::string testCase(const CheckReport& report, std::string_view rule,
                     const std::vector<const Finding*>& findings, Counts& counts) {
  ++counts.tests;
  const std::string_view family = rule.substr(0, rule.find('.'));
  std::string text =
      fmt::format("    <testcase classname=\"rocinante.check.{}\" name=\"{}\" time=\"0\"",
                  xmlText(family), xmlText(rule));
  if (findings.empty()) return text + "/>\n";
  text += ">\n";
  std::string failures, others, accepted;
  const Finding* first_failure = nullptr;
  for (const Finding* finding : findings) {
    const bool fails = report.isFailure(*finding);
    if (fails && first_failure == nullptr) first_failure = finding;
    (fails ? failures : finding->accepted ? accepted : others) += paragraphOf(report, *finding);
  }
  if (first_failure != nullptr) {
    ++counts.failures;
    text += fmt::format("      <failure message=\"{}\" type=\"{}\">{}</failure>\n",
                        xmlText(first_failure->text), nameOf(first_failure->severity),
                        xmlText(failures));
  } else if (!accepted.empty() && others.empty()) {
    ++counts.skipped;
    text += "      <skipped message=\"accepted by the baseline\"/>\n";
  }
  if (!others.empty() || !accepted.empty()) {
    text += fmt::format("      <system-out>{}</system-out>\n", xmlText(others + accepted));
  }
  return text + "    </testcase>\n";
}

}  // namespace

std::string checkJunit(const CheckReport& report) {
  std::map<std::string_view, std::vector<const Finding*>> by_rule;
  for (const Rule& rule : allRules()) by_rule[rule.id];
  for (const Finding& finding : report.findings) by_rule[finding.rule].push_back(&finding);

  Counts counts;
  std::string cases;
  for (const auto& [rule, findings] : by_rule) cases += testCase(report, rule, findings, counts);
  // Without it, a session that was not judged would look like one without faults.
  ++counts.tests;
  cases += "    <testcase classname=\"rocinante.check\" name=\"judged\" time=\"0\"";
  if (report.verdict == CheckVerdict::nothing_judged ||
      report.verdict == CheckVerdict::interrupted) {
    ++counts.errors;
    cases += fmt::format(">\n      <error message=\"{}\" type=\"{}\"/>\n    </testcase>\n",
                         xmlText(verdictText(report.verdict)), nameOf(report.verdict));
  } else {
    cases += "/>\n";
  }
  const std::string totals = fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\"", counts.tests,
                                         counts.failures, counts.errors);
  std::string name = "rocinante check " + report.cell;
  if (!report.session.empty()) name += " " + report.session;
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites name=\"rocinante check\" {0} time=\"0\">\n"
      "  <testsuite name=\"{1}\" {0} skipped=\"{2}\" time=\"0\">\n{3}"
      "  </testsuite>\n</testsuites>\n",
      totals, xmlText(name), counts.skipped, cases);
}

}  // namespace rocinante
