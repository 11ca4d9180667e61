#include <nlohmann/json.hpp>

#include "core/check/reports/report_formats.h"
#include "core/check/rules/rule_list.h"

namespace rocinante {
namespace {

using Json = nlohmann::ordered_json;

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
  json["packet"] = finding.packet ? Json(*finding.packet) : Json(nullptr);
  json["subject"] = finding.subject;
  json["text"] = finding.text;
  json["example"] = finding.example;
  json["hint"] = finding.hint;
  json["accepted"] = finding.accepted;
  if (const Rule* const rule = findRule(finding.rule)) json["title"] = std::string(rule->title);
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

}  // namespace

std::string checkJson(const CheckReport& report) {
  Json json;
  json["format"] = 1;
  json["verdict"] = std::string(nameOf(report.verdict));
  json["cell"] = report.cell;
  json["session"] = report.session.empty() ? Json(nullptr) : Json(report.session);
  json["datagrams"] = report.datagrams;
  json["packets"] = report.packets;
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
  // Examples are a sender's bytes, which need not be UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rocinante
