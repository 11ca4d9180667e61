#include <fmt/format.h>

#include <map>

#include "core/check/reports/report_formats.h"
#include "core/check/rules/rule_list.h"
#include "core/report/account.h"
#include "core/report/junit.h"

namespace rocinante {
namespace {

std::string paragraphOf(const CheckReport& report, const Finding& finding) {
  const std::string place = finding.place();
  std::string text = fmt::format("{}: {}{}{}\n", nameOf(finding.severity), place,
                                 place.empty() ? "" : ": ", sentenceOf(finding));
  if (finding.first) text += "  " + whenText(report, finding) + "\n";
  if (!finding.example.empty()) text += "  such as: " + finding.example + "\n";
  if (!finding.hint.empty()) text += "  hint: " + finding.hint + "\n";
  return text;
}

/// The test case of one rule, with its findings.
JunitCase testCase(const CheckReport& report, std::string_view rule,
                   const std::vector<const Finding*>& findings) {
  JunitCase test;
  test.classname = fmt::format("rocinante.check.{}", rule.substr(0, rule.find('.')));
  test.name = rule;
  std::string failures, others, accepted;
  for (const Finding* finding : findings) {
    const bool fails = report.isFailure(*finding);
    if (fails && failures.empty()) {
      test.message = sentenceOf(*finding);
      test.type = nameOf(finding->severity);
    }
    (fails ? failures : finding->accepted ? accepted : others) += paragraphOf(report, *finding);
  }
  if (!failures.empty()) {
    test.outcome = JunitCase::Outcome::failure;
    test.text = failures;
  } else if (!accepted.empty() && others.empty()) {
    test.outcome = JunitCase::Outcome::skipped;
    test.message = "accepted by the baseline";
  } else if (findings.empty()) {
    auto why = report.unjudged.find(rule.substr(0, rule.find('.')));
    if (why == report.unjudged.end()) why = report.unjudged.find(rule);
    if (why != report.unjudged.end()) {
      test.outcome = JunitCase::Outcome::skipped;
      test.message = "nothing to judge: " + why->second;
    }
  }
  test.output = others + accepted;
  return test;
}

}  // namespace

std::string checkJunit(const CheckReport& report) {
  std::map<std::string_view, std::vector<const Finding*>> by_rule;
  for (const Rule& rule : allRules()) by_rule[rule.id];
  for (const Finding& finding : report.findings) by_rule[finding.rule].push_back(&finding);

  JunitSuite suite;
  suite.collection = "rocinante check";
  suite.name = "rocinante check " + report.cell;
  if (!report.session.empty()) suite.name += " " + report.session;
  for (const auto& [rule, findings] : by_rule) {
    suite.cases.push_back(testCase(report, rule, findings));
  }
  // Without it, a session that was not judged would look like one without faults.
  JunitCase& judged = suite.cases.emplace_back();
  judged.classname = "rocinante.check";
  judged.name = "judged";
  if (report.verdict == CheckVerdict::nothing_judged ||
      report.verdict == CheckVerdict::interrupted) {
    judged.outcome = JunitCase::Outcome::error;
    judged.message = verdictText(report.verdict);
    judged.type = nameOf(report.verdict);
  }
  return junitXml(suite);
}

}  // namespace rocinante
