#include <algorithm>
#include <array>
#include <map>

#include "core/base/hash.h"
#include "core/base/version.h"
#include "core/check/reports/baseline.h"
#include "core/check/reports/report_formats.h"
#include "core/check/rules/rule_list.h"
#include "core/check/rules/rule_page.h"
#include "core/report/account.h"
#include "core/report/json_text.h"

namespace rocinante {
namespace {

/// SARIF's names of the severities.
std::string levelOf(Severity severity) { return std::string(nameOf(severity)); }

std::string textOf(std::string_view paragraphs, std::string_view otherwise) {
  return std::string(paragraphs.empty() ? otherwise : paragraphs);
}

Json ruleJson(const Rule& rule, const std::string& pages) {
  Json json;
  json["id"] = std::string(rule.id);
  json["shortDescription"]["text"] = std::string(rule.title);
  const RulePage* const page = findRulePage(rule.id);
  json["fullDescription"]["text"] =
      textOf(page != nullptr ? meaningOf(*page) : std::string_view(), rule.title);
  if (page != nullptr) {
    json["help"]["text"] = textOf(mendOf(*page), rule.title);
    json["help"]["markdown"] = explanationOf(*page);
  }
  if (!pages.empty()) {
    json["helpUri"] = pages + (pages.ends_with('/') ? "" : "/") + placeOf(rule.id);
  }
  json["defaultConfiguration"]["level"] = levelOf(rule.severity);
  return json;
}

Json locationOf(const CheckReport& report, const Finding& finding) {
  Json location;
  Json& physical = location["physicalLocation"];
  // Code scanning shows nothing without a file: a session's findings are shown at its cell.
  physical["artifactLocation"]["uri"] = uriOf(!finding.file.empty() ? finding.file
                                              : report.has_cell     ? report.cell
                                                                    : report.session);
  physical["region"]["startLine"] = std::max(finding.line, 1);
  if (finding.line > 0 && finding.column > 0) physical["region"]["startColumn"] = finding.column;
  if (!finding.subject.empty()) {
    location["logicalLocations"] = {
        {{"name", finding.subject},
         {"fullyQualifiedName", report.session + "/" + finding.subject}}};
  }
  return location;
}

Json resultJson(const CheckReport& report, const Finding& finding,
                const std::map<std::string_view, std::size_t>& numbers) {
  Json json;
  json["ruleId"] = finding.rule;
  if (const auto number = numbers.find(finding.rule); number != numbers.end()) {
    json["ruleIndex"] = number->second;
  }
  json["level"] = levelOf(finding.severity);
  std::string text = sentenceOf(finding);
  if (finding.first) text += "; " + whenText(report, finding);
  if (!finding.hint.empty()) text += ". " + finding.hint;
  json["message"]["text"] = text;
  json["locations"] = Json::array({locationOf(report, finding)});
  json["occurrenceCount"] = finding.count;
  // The key of a baseline: code scanning uses it to tell known alerts from new ones.
  const std::string identity = baselineKeyOf(report, finding).text();
  json["partialFingerprints"]["rocinanteFinding/v1"] = hexOf(xxh3(bytesOf(identity)));
  if (finding.accepted) json["suppressions"] = {{{"kind", "external"}, {"status", "accepted"}}};
  Json& properties = json["properties"];
  properties["subject"] = finding.subject;
  properties["example"] = finding.example;
  if (finding.packet) properties["packet"] = *finding.packet;
  return json;
}

}  // namespace

std::string uriOf(std::string_view path) {
  constexpr std::string_view kUnreserved =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string uri = path.starts_with('/') ? "file://" : "";
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (kUnreserved.find(c) != kUnreserved.npos) {
      uri += c;
    } else {
      uri += {'%', kDigits[byte >> 4U], kDigits[byte & 15U]};
    }
  }
  return uri;
}

std::string checkSarif(const CheckReport& report, const std::string& pages) {
  Json run;
  const std::string full_version = version();
  Json& driver = run["tool"]["driver"];
  driver["name"] = "rocinante-check";
  driver["version"] = full_version.substr(full_version.find(' ') + 1);
  std::map<std::string_view, std::size_t> numbers;
  driver["rules"] = Json::array();
  for (const Rule& rule : allRules()) {
    numbers.emplace(rule.id, numbers.size());
    driver["rules"].push_back(ruleJson(rule, pages));
  }
  const bool is_whole =
      report.verdict == CheckVerdict::compatible || report.verdict == CheckVerdict::incompatible;
  Json invocation;
  invocation["executionSuccessful"] = is_whole;
  if (!is_whole) {
    invocation["toolExecutionNotifications"] = {
        {{"level", "error"}, {"message", {{"text", verdictText(report.verdict)}}}}};
  }
  run["invocations"] = Json::array({invocation});
  run["columnKind"] = "unicodeCodePoints";
  run["results"] = Json::array();
  for (const Finding& finding : report.findings) {
    run["results"].push_back(resultJson(report, finding, numbers));
  }
  Json json;
  json["$schema"] = "https://json.schemastore.org/sarif-2.1.0.json";
  json["version"] = "2.1.0";
  json["runs"] = Json::array({run});
  return jsonText(json, 1);
}

}  // namespace rocinante
