#include "core/check/watch/finding_change_text.h"

#include <fmt/format.h>

#include "core/base/count_text.h"
#include "core/base/duration_text.h"
#include "core/base/plain_text.h"
#include "core/check/rules/rule_list.h"
#include "core/report/json_text.h"

namespace rocinante {
namespace {

WallTime wallTimeOf(LogTime time) { return WallTime(time.time_since_epoch()); }

Json momentJson(const std::optional<LogTime>& time) {
  return time ? Json(rfc3339Text(wallTimeOf(*time))) : Json(nullptr);
}

}  // namespace

std::string momentText(LogTime time) {
  const auto rounded = std::chrono::floor<std::chrono::milliseconds>(time.time_since_epoch());
  std::string text = rfc3339Text(WallTime(Nanoseconds(rounded)));
  // Nine decimals and Z.
  text.replace(text.size() - 7, 7, "Z");
  return text;
}

std::string findingChangeText(const FindingChange& change) {
  const Finding& finding = change.finding;
  const std::string place = finding.place();
  std::string text = fmt::format(
      "{} {}: {}{}{}: {} [{}]", momentText(change.at), change.begins ? "begins" : "ends", place,
      place.empty() ? "" : ": ", nameOf(finding.severity), plainText(finding.text), finding.rule);
  if (change.begins || !finding.first) return text;
  const auto lasted = std::chrono::floor<std::chrono::milliseconds>(*finding.last - *finding.first);
  return text +
         fmt::format(" ({} in {} s)", countText(finding.count, "time"), secondsText(lasted, 1));
}

std::string findingChangeJson(const FindingChange& change) {
  const Finding& finding = change.finding;
  Json json;
  json["format"] = 1;
  json["event"] = change.begins ? "begins" : "ends";
  json["at"] = momentJson(change.at);
  json["fails"] = change.fails;
  json["rule"] = finding.rule;
  json["severity"] = std::string(nameOf(finding.severity));
  json["count"] = finding.count;
  json["first"] = momentJson(finding.first);
  json["last"] = momentJson(finding.last);
  json["packet"] = orNull(finding.packet);
  json["subject"] = finding.subject;
  json["text"] = finding.text;
  json["example"] = finding.example;
  json["hint"] = finding.hint;
  if (const Rule* const rule = findRule(finding.rule)) json["title"] = std::string(rule->title);
  if (!finding.file.empty()) {
    json["file"] = finding.file;
    json["line"] = finding.line;
    json["column"] = finding.column;
  }
  return jsonText(json, -1);
}

}  // namespace rocinante
