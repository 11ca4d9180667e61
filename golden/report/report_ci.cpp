#include "golden/report/report_ci.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/hash.h"
#include "core/base/plain_text.h"
#include "core/base/version.h"
#include "core/check/reports/report_formats.h"
#include "golden/why/frame_why.h"

namespace rocinante {
namespace {

using SarifJson = nlohmann::ordered_json;

constexpr std::array kFailures = {
    std::pair{FrameVerdict::different, "The frame differs from its golden."},
    std::pair{FrameVerdict::missing, "No golden was approved for the frame yet."},
    std::pair{FrameVerdict::unstable, "Drawn again, the frame differs from itself."},
    std::pair{FrameVerdict::incomparable, "The frame could not be judged."},
    std::pair{FrameVerdict::unexpected,
              "The frame equals its golden, though its case expects a difference."}};

std::string ruleOf(FrameVerdict verdict) { return "golden." + std::string(nameOf(verdict)); }

/// The rule that decided and the explanation, as lines.
std::string failureText(const JudgedFrame& judged) {
  std::string text = plainText(judged.frame.name + ": " + judged.rule);
  if (judged.why) {
    for (const std::string& line : whyLines(*judged.why)) text += "\n" + plainText(line);
  }
  return text;
}

SarifJson frameResult(const SuiteReport& report, const JudgedFrame& judged) {
  SarifJson result;
  result["ruleId"] = ruleOf(judged.verdict);
  for (std::size_t i = 0; i < kFailures.size(); ++i) {
    if (kFailures[i].first == judged.verdict) result["ruleIndex"] = i;
  }
  result["level"] = "error";
  result["message"]["text"] = failureText(judged);
  SarifJson location;
  location["physicalLocation"]["artifactLocation"]["uri"] = uriOf(report.suite);
  location["physicalLocation"]["region"]["startLine"] = std::max(judged.frame.line, 1);
  location["logicalLocations"] = {{{"name", judged.frame.name}}};
  result["locations"] = {location};
  if (judged.golden) {
    result["properties"] = {
        {"key", judged.key}, {"golden_key", judged.golden->key}, {"tier", judged.tolerance.name}};
  }
  // Code scanning recognizes known alerts by it.
  result["partialFingerprints"]["rocinanteFrame/v1"] =
      hexOf(xxh3(bytesOf(report.suite + "\n" + judged.frame.name)));
  return result;
}

}  // namespace

std::string reportSarif(const SuiteReport& report) {
  SarifJson run;
  SarifJson& driver = run["tool"]["driver"];
  const std::string full_version = version();
  driver["name"] = "rocinante-golden";
  driver["version"] = full_version.substr(full_version.find(' ') + 1);
  driver["rules"] = SarifJson::array();
  for (const auto& [verdict, meaning] : kFailures) {
    SarifJson rule;
    rule["id"] = ruleOf(verdict);
    rule["shortDescription"]["text"] = meaning;
    rule["defaultConfiguration"]["level"] = "error";
    driver["rules"].push_back(std::move(rule));
  }
  SarifJson invocation;
  invocation["executionSuccessful"] =
      !report.frames.empty() && report.count(FrameVerdict::incomparable) == 0;
  run["invocations"] = {invocation};
  run["columnKind"] = "unicodeCodePoints";
  run["results"] = SarifJson::array();
  for (const JudgedFrame& judged : report.frames) {
    if (!isFine(judged.verdict)) run["results"].push_back(frameResult(report, judged));
  }
  SarifJson json;
  json["$schema"] = "https://json.schemastore.org/sarif-2.1.0.json";
  json["version"] = "2.1.0";
  json["runs"] = {run};
  return json.dump(1, ' ', false, SarifJson::error_handler_t::replace) + "\n";
}

std::string reportGithub(const SuiteReport& report) {
  std::string text;
  for (const JudgedFrame& judged : report.frames) {
    if (isFine(judged.verdict)) continue;
    const std::string title = ruleOf(judged.verdict), what = failureText(judged);
    text += githubCommand({"error", report.suite, judged.frame.line, 0, title, what});
  }
  return text;
}

}  // namespace rocinante
