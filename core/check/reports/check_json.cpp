
#include "core/check/reports/report_formats.h"
#include "core/check/rules/rule_list.h"
#include "core/report/account.h"
#include "core/report/json_text.h"

namespace rocinante {
namespace {

Json secondsOf(const CheckReport& report, const std::optional<LogTime>& time) {
  if (!time) return nullptr;
  return static_cast<double>((*time - report.origin).count()) / 1e9;
}

Json jsonOf(const CheckReport& report, const Finding& finding) {
  Json json;
  json["rule"] = finding.rule;
  json["severity"] = std::string(nameOf(finding.severity));
  json["count"] = finding.count;
  json["first_s"] = secondsOf(report, finding.first);
  json["last_s"] = secondsOf(report, finding.last);
  json["packet"] = orNull(finding.packet);
  json["subject"] = finding.subject;
  json["text"] = sentenceOf(finding);
  json["example"] = finding.example;
  json["hint"] = finding.hint;
  json["accepted"] = finding.accepted;
  if (const Rule* const rule = findRule(finding.rule)) json["title"] = std::string(rule->title);
  if (isOfPicturesOnly(finding.rule)) json["pictures_only"] = true;
  if (!finding.when.counts().empty()) {
    json["when"] = {{"start_s", secondsOf(report, finding.when.start())},
                    {"bin_s", static_cast<double>(finding.when.width().count()) / 1e9},
                    {"counts", finding.when.counts()}};
  }
  if (!finding.file.empty()) {
    json["file"] = finding.file;
    json["line"] = finding.line;
    json["column"] = finding.column;
  }
  return json;
}

Json jsonOf(const CheckReport& report, const CheckedClearance& checked) {
  Json json;
  json["name"] = checked.name;
  json["devices"] = {checked.device_a, checked.device_b};
  json["min_m"] = checked.min_m;
  json["least_m"] = checked.least_m;
  json["penetrating"] = !(checked.least_m > 0);
  json["links"] = {checked.link_a, checked.link_b};
  json["points"] = {checked.on_a, checked.on_b};
  json["at_s"] = secondsOf(report, checked.at);
  json["violations"] = checked.violations;
  json["spans"] = Json::array();
  for (const CheckedClearance::Span& span : checked.spans) {
    json["spans"].push_back({{"from_s", secondsOf(report, span.from)},
                             {"until_s", secondsOf(report, span.until)},
                             {"least_m", span.least_m}});
  }
  return json;
}

}  // namespace

std::string checkJson(const CheckReport& report) {
  Json json;
  json["format"] = 1;
  json["verdict"] = std::string(nameOf(report.verdict));
  json["cell"] = orNull(report.cell);
  if (!report.has_cell) {
    for (const auto& [rules, why] : report.unjudged) json["not_judged"].push_back(rules);
  }
  json["session"] = orNull(report.session);
  json["datagrams"] = report.datagrams;
  json["packets"] = report.packets;
  for (const auto& [reason, count] : report.untrusted) json["untrusted"][reason] = count;
  json["sources"] = report.sources;
  json["duration_s"] = static_cast<double>(report.duration.count()) / 1e9;
  json["errors"] = report.countOf(Severity::error);
  json["warnings"] = report.countOf(Severity::warning);
  json["notes"] = report.countOf(Severity::note);
  json["accepted"] = report.countOfAccepted();
  json["fail_on"] = std::string(nameOf(report.fail_on));
  json["findings"] = Json::array();
  for (const Finding& finding : report.findings) {
    json["findings"].push_back(jsonOf(report, finding));
  }
  json["left_out"] = leftOutJson(accountOf(report.findings));
  for (const CheckedClearance& checked : report.clearances) {
    json["clearances"].push_back(jsonOf(report, checked));
  }
  return jsonText(json);
}

}  // namespace rocinante
