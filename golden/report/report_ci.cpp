#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/figure_text.h"
#include "core/base/hash.h"
#include "core/base/plain_text.h"
#include "core/base/version.h"
#include "core/check/reports/report_formats.h"
#include "core/report/json_text.h"
#include "golden/report/cause_groups.h"
#include "golden/report/report_formats.h"
#include "golden/report/report_pictures.h"
#include "golden/report/report_runs.h"
#include "golden/why/frame_why.h"

namespace rocinante {
namespace {

constexpr std::array kFailures = {
    std::pair{FrameVerdict::different, "The frame differs from its golden."},
    std::pair{FrameVerdict::missing, "No golden was approved for the frame yet."},
    std::pair{FrameVerdict::unstable, "Drawn again, the frame differs from itself."},
    std::pair{FrameVerdict::incomparable, "The frame could not be judged."},
    std::pair{FrameVerdict::unexpected,
              "The frame equals its golden, though its case expects a difference."}};

std::string ruleOf(FrameVerdict verdict) { return "golden." + std::string(nameOf(verdict)); }

/// The cause, the rule that decided and the explanation, as lines.
std::string failureText(const std::vector<CauseGroup>& groups, const JudgedFrame& judged) {
  std::string text = plainText(causeSentence(groups, judged));
  if (!text.empty()) text += "\n";
  text += plainText(judged.frame.name + ": " + judged.rule);
  if (judged.why) {
    for (const std::string& line : whyLines(*judged.why)) text += "\n" + plainText(line);
  }
  return text;
}

/// `text` with everything escaped that Markdown or HTML would act on.
std::string markdownText(std::string_view text) {
  std::string escaped;
  for (const char each : plainText(text)) {
    if (each == '<') {
      escaped += "&lt;";
      continue;
    }
    if (std::string_view("\\`*_{}[]()#+!|~&").find(each) != std::string_view::npos) escaped += '\\';
    escaped += each;
  }
  return escaped;
}

/// `text` as code, between more backquotes than it has in a row.
std::string markdownCode(std::string_view text) {
  const std::string plain = plainText(text);
  std::string fence = "`";
  while (plain.find(fence) != std::string::npos) fence += '`';
  const std::string_view space = fence.size() > 1 ? " " : "";
  return fmt::format("{}{}{}{}{}", fence, space, plain, space, fence);
}

/// The same of a run.
std::string failureText(const JudgedRun& run) {
  std::string text = plainText(run.name + ": " + run.rule);
  if (run.judgement.findings.size() < 2 && run.changes.empty()) return text;
  for (const std::string& line : runReasons(run, 20)) text += "\n" + line;
  return text;
}

std::string runRuleOf(FrameVerdict verdict) { return "golden.run-" + std::string(nameOf(verdict)); }

constexpr std::array kRunFailures = {
    std::pair{FrameVerdict::different, "The session differs from the accepted ones."},
    std::pair{FrameVerdict::missing, "No session was accepted for the run yet."},
    std::pair{FrameVerdict::incomparable, "The session could not be judged."}};

Json runResult(const SuiteReport& report, const JudgedRun& run) {
  Json result;
  result["ruleId"] = runRuleOf(run.verdict);
  for (std::size_t i = 0; i < kRunFailures.size(); ++i) {
    if (kRunFailures[i].first == run.verdict) result["ruleIndex"] = kFailures.size() + i;
  }
  result["level"] = "error";
  result["message"]["text"] = failureText(run);
  Json location;
  location["physicalLocation"]["artifactLocation"]["uri"] = uriOf(report.suite);
  location["physicalLocation"]["region"]["startLine"] = std::max(run.line, 1);
  location["logicalLocations"] = {{{"name", run.name}}};
  result["locations"] = Json::array({location});
  result["partialFingerprints"]["rocinanteRun/v1"] =
      hexOf(xxh3(bytesOf(report.suite + "\n" + run.name)));
  return result;
}

void addRunsMarkdown(const SuiteReport& report, std::string& text) {
  for (const JudgedRun& run : report.runs) {
    if (isFine(run.verdict)) continue;
    text += fmt::format("**Run {}: {}**\n\n", markdownText(run.name), nameOf(run.verdict));
    if (run.judgement.findings.empty()) text += fmt::format("- {}\n", markdownText(run.rule));
    for (const std::string& line : runReasons(run, 20)) {
      text += fmt::format("- {}\n", markdownText(line));
    }
    text += "\n";
  }
}

/// A table for each cause, and the explanation of its first frame.
void addFramesMarkdown(const SuiteReport& report, std::string& text) {
  for (const CauseGroup& group : causeGroups(report.frames)) {
    if (!group.sentence.empty()) {
      std::string sentence = markdownText(group.sentence);
      sentence.front() = 'I';  // "in"
      text += fmt::format("**{}**\n\n", sentence);
    }
    for (const std::string& cause : group.also) text += fmt::format("- {}\n", markdownText(cause));
    if (!group.also.empty()) text += "\n";
    text += "| frame | verdict | rule |\n|---|---|---|\n";
    for (const JudgedFrame* const judged : group.frames) {
      text += fmt::format("| {} | {} | {} |\n", markdownText(judged->frame.name),
                          nameOf(judged->verdict), markdownText(ruleText(group, *judged)));
    }
    text += "\n";
    for (const JudgedFrame* const judged : group.frames) {
      if (!judged->why) continue;
      text += fmt::format("**Why {} changed**\n\n", markdownText(judged->frame.name));
      for (const std::string& line : whyLines(*judged->why)) {
        text += fmt::format("- {}\n", markdownText(line));
      }
      text += "\n";
      if (!group.sentence.empty()) break;
    }
  }
}

Json frameResult(const SuiteReport& report, const std::vector<CauseGroup>& groups,
                 const JudgedFrame& judged) {
  Json result;
  result["ruleId"] = ruleOf(judged.verdict);
  for (std::size_t i = 0; i < kFailures.size(); ++i) {
    if (kFailures[i].first == judged.verdict) result["ruleIndex"] = i;
  }
  result["level"] = "error";
  result["message"]["text"] = failureText(groups, judged);
  Json location;
  location["physicalLocation"]["artifactLocation"]["uri"] = uriOf(report.suite);
  location["physicalLocation"]["region"]["startLine"] = std::max(judged.frame.line, 1);
  location["logicalLocations"] = {{{"name", judged.frame.name}}};
  result["locations"] = Json::array({location});
  if (judged.golden) {
    result["properties"] = {
        {"key", judged.key}, {"golden_key", judged.golden->key}, {"tier", judged.tolerance.name}};
  }
  // Code scanning recognizes known alerts by it.
  result["partialFingerprints"]["rocinanteFrame/v1"] =
      hexOf(xxh3(bytesOf(report.suite + "\n" + judged.frame.name)));
  return result;
}

/// Where the picture of all differences is, and what it shows: a job's page shows no file of the
/// job.
std::string sheetText(const SuiteReport& report, const std::string& page) {
  const std::optional<DifferenceSheet> sheet = differenceSheet(report);
  if (!sheet) return {};
  const std::string file =
      (std::filesystem::path(page).parent_path() / kDifferenceSheetFile).string();
  std::string rows;
  for (const JudgedFrame* const row : sheet->rows) {
    rows += (rows.empty() ? "" : ", ") + markdownText(row->frame.name);
  }
  std::string text = fmt::format(
      "Frame, golden and difference beside one another: [{}]({}); rows from the top: {}",
      markdownText(kDifferenceSheetFile), uriOf(file), rows);
  if (sheet->left_out > 0) text += fmt::format("; {} more are left out", sheet->left_out);
  return text + ".\n\n";
}

}  // namespace

std::string reportSarif(const SuiteReport& report) {
  Json run;
  Json& driver = run["tool"]["driver"];
  const std::string full_version = version();
  driver["name"] = "rocinante-golden";
  driver["version"] = full_version.substr(full_version.find(' ') + 1);
  driver["rules"] = Json::array();
  for (const auto& [verdict, meaning] : kFailures) {
    Json rule;
    rule["id"] = ruleOf(verdict);
    rule["shortDescription"]["text"] = meaning;
    rule["defaultConfiguration"]["level"] = "error";
    driver["rules"].push_back(std::move(rule));
  }
  if (!report.runs.empty()) {
    for (const auto& [verdict, meaning] : kRunFailures) {
      Json rule;
      rule["id"] = runRuleOf(verdict);
      rule["shortDescription"]["text"] = meaning;
      rule["defaultConfiguration"]["level"] = "error";
      driver["rules"].push_back(std::move(rule));
    }
  }
  Json invocation;
  invocation["executionSuccessful"] =
      report.frames.size() + report.runs.size() > 0 &&
      report.count(FrameVerdict::incomparable) == 0 &&
      std::ranges::count(report.runs, FrameVerdict::incomparable, &JudgedRun::verdict) == 0;
  run["invocations"] = Json::array({invocation});
  run["columnKind"] = "unicodeCodePoints";
  run["results"] = Json::array();
  const std::vector<CauseGroup> groups = causeGroups(report.frames);
  for (const JudgedFrame& judged : report.frames) {
    if (!isFine(judged.verdict)) run["results"].push_back(frameResult(report, groups, judged));
  }
  for (const JudgedRun& judged : report.runs) {
    if (!isFine(judged.verdict)) run["results"].push_back(runResult(report, judged));
  }
  Json json;
  json["$schema"] = "https://json.schemastore.org/sarif-2.1.0.json";
  json["version"] = "2.1.0";
  json["runs"] = Json::array({run});
  return jsonText(json, 1);
}

std::string reportGithub(const SuiteReport& report) {
  std::string text;
  const std::vector<CauseGroup> groups = causeGroups(report.frames);
  for (const JudgedFrame& judged : report.frames) {
    if (isFine(judged.verdict)) continue;
    const std::string title = ruleOf(judged.verdict), what = failureText(groups, judged);
    text += githubCommand({"error", report.suite, judged.frame.line, 0, title, what});
  }
  for (const JudgedRun& run : report.runs) {
    if (isFine(run.verdict)) continue;
    const std::string title = runRuleOf(run.verdict), what = failureText(run);
    text += githubCommand({"error", report.suite, run.line, 0, title, what});
  }
  return text;
}

std::string asAcceptedText(const SuiteReport& report) {
  const auto part = [](const auto& judged, auto verdict, const char* noun) {
    return fmt::format("{} of {} as accepted", std::ranges::count_if(judged, isFine, verdict),
                       countText(judged.size(), noun));
  };
  std::string text;
  if (!report.frames.empty() || report.runs.empty()) {
    text = part(report.frames, &JudgedFrame::verdict, "frame");
  }
  if (report.runs.empty()) return text;
  return text + (text.empty() ? "" : ", ") + part(report.runs, &JudgedRun::verdict, "run");
}

std::string reportMarkdown(const SuiteReport& report, const std::string& page) {
  std::string text =
      fmt::format("## {}: {}\n\n", markdownText(report.suite), asAcceptedText(report));
  addRunsMarkdown(report, text);
  addFramesMarkdown(report, text);
  const bool is_all_fine = std::ranges::all_of(report.frames, isFine, &JudgedFrame::verdict) &&
                           std::ranges::all_of(report.runs, isFine, &JudgedRun::verdict);
  if (!is_all_fine) {
    if (!page.empty()) text += sheetText(report, page);
    text += fmt::format("Repeat: {}\n\n", markdownCode(report.run_command));
    if (!report.approve_command.empty()) {
      text += fmt::format("Accept all: {}\n\n", markdownCode(report.approve_command));
    }
  }
  for (const std::string& note : report.notes) text += fmt::format("- {}\n", markdownText(note));
  if (!report.notes.empty()) text += "\n";
  if (report.frames.empty() && !report.runs.empty()) {
    return text + (page.empty() ? "" : fmt::format("Curves in {}.\n\n", markdownCode(page)));
  }
  text += fmt::format("Drawn by {}", markdownCode(report.renderer));
  return text + (page.empty() ? ".\n\n" : fmt::format("; pictures in {}.\n\n", markdownCode(page)));
}

}  // namespace rocinante
