#include "golden/report/report_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/figure_text.h"
#include "core/base/json_read.h"
#include "core/base/plain_text.h"
#include "core/report/json_text.h"
#include "golden/suite/suite_case.h"
#include "golden/why/run_pictures.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxReadFindings = 10'000;
constexpr std::size_t kMaxReadPoints = 2'000;

Json numbersJson(const std::vector<double>& numbers) {
  Json list = Json::array();
  for (const double number : numbers) {
    list.push_back(std::isfinite(number) ? Json(number) : Json(nullptr));
  }
  return list;
}

Json findingJson(const RunFinding& finding) {
  Json json = {{"kind", nameOf(finding.kind)},
               {"item", finding.item},
               {"what", finding.what},
               {"first_accepted_ns", finding.first_accepted.count()},
               {"first_run_ns", finding.first_run.count()},
               {"until_accepted_ns", finding.until_accepted.count()}};
  if (finding.largest) {
    json["unit"] = finding.unit;
    json["largest"] = *finding.largest;
    json["limit"] = finding.limit;
    json["largest_accepted_ns"] = finding.at_accepted.count();
    json["largest_run_ns"] = finding.at_run.count();
  }
  if (!finding.accept.empty()) json["accept"] = finding.accept;
  if (!finding.curve.seconds.empty()) {
    json["curve"] = {{"seconds", numbersJson(finding.curve.seconds)},
                     {"least", numbersJson(finding.curve.least)},
                     {"most", numbersJson(finding.curve.most)},
                     {"value", numbersJson(finding.curve.value)}};
  }
  return json;
}

Json picturesJson(const JudgedRun& run) {
  Json pictures = Json::array();
  for (std::size_t i = 0; i < run.pictures.size(); ++i) {
    const RunPicture& picture = run.pictures[i];
    pictures.push_back({{"file", runPictureFile(run, i)},
                        {"device", picture.device},
                        {"run_ns", picture.at_run.count()},
                        {"accepted_ns", picture.at_accepted.count()},
                        {"left_out", picture.left_out}});
  }
  return pictures;
}

std::vector<double> readNumbers(const nlohmann::json& object, const char* key) {
  std::vector<double> numbers;
  for (const auto& item : arrayIn(object, key)) {
    if (numbers.size() == kMaxReadPoints) break;
    numbers.push_back(item.is_number() ? item.get<double>()
                                       : std::numeric_limits<double>::quiet_NaN());
  }
  return numbers;
}

}  // namespace

Json coverageJson(const RunCoverage& coverage) {
  return {{"judged", coverage.judged},
          {"lost", coverage.lost},
          {"masked", coverage.masked},
          {"left_out", leftOutJson(coverage.left_out)}};
}

RunCoverage readCoverage(const nlohmann::json& judged) {
  RunCoverage coverage;
  const auto& found = fieldIn(judged, "coverage");
  const auto itemsIn = [&](const char* key) {
    const auto items = textsIn(found, key);
    return std::set<std::string>(items.begin(), items.end());
  };
  coverage.judged = itemsIn("judged");
  coverage.lost = itemsIn("lost");
  coverage.masked = itemsIn("masked");
  for (const auto& item : arrayIn(fieldIn(found, "left_out"), "items")) {
    if (!item.is_object()) continue;
    LeftOut one{textIn(item, "kind"), textIn(item, "name"), textIn(item, "reason"),
                textIn(item, "first"), numberIn<std::uint64_t>(item, "count")};
    if (textIn(item, "severity") == nameOf(Severity::warning)) one.severity = Severity::warning;
    coverage.left_out.leaveOut(std::move(one));
  }
  return coverage;
}

namespace {

RunFinding readFinding(const nlohmann::json& json) {
  RunFinding finding;
  finding.kind =
      enumeratorNamed(textIn(json, "kind"), RunFinding::Kind::drawing).value_or(finding.kind);
  finding.item = textIn(json, "item");
  finding.what = textIn(json, "what");
  finding.accept = textIn(json, "accept");
  const auto time = [&](const char* key) { return Nanoseconds(numberIn<std::int64_t>(json, key)); };
  finding.first_accepted = time("first_accepted_ns");
  finding.first_run = time("first_run_ns");
  finding.until_accepted = time("until_accepted_ns");
  if (json.contains("largest")) {
    finding.unit = textIn(json, "unit");
    finding.largest = numberIn<double>(json, "largest");
    finding.limit = numberIn<double>(json, "limit");
    finding.at_accepted = time("largest_accepted_ns");
    finding.at_run = time("largest_run_ns");
  }
  const auto& curve = fieldIn(json, "curve");
  RunCurve read{readNumbers(curve, "seconds"), readNumbers(curve, "least"),
                readNumbers(curve, "most"), readNumbers(curve, "value")};
  const std::size_t count = read.seconds.size();
  if (read.least.size() == count && read.most.size() == count && read.value.size() == count) {
    finding.curve = std::move(read);
  }
  return finding;
}

/// The entries of `limits` with which the run were the same; empty when limits alone do not help.
std::string acceptingLimits(const JudgedRun& run) {
  constexpr std::size_t kMostEntries = 6;
  const auto& findings = run.judgement.findings;
  const auto isAccepted = [](const RunFinding& finding) { return !finding.accept.empty(); };
  const bool is_of_suite = run.line > 0;
  if (!is_of_suite || findings.size() > kMostEntries || !std::ranges::all_of(findings, isAccepted))
    return {};
  // An item has one table: `"arm" = { pose_mm = 2 }` and `"arm" = { pose_deg = 1 }` are joined.
  std::vector<std::pair<std::string_view, std::string>> entries;
  for (const RunFinding& finding : findings) {
    const auto its =
        std::ranges::find(entries, finding.item, &decltype(entries)::value_type::first);
    const std::size_t begin = finding.accept.rfind("{ ");
    if (its == entries.end()) {
      entries.emplace_back(finding.item, finding.accept);
    } else if (its->second.ends_with(" }") && begin != std::string::npos) {
      its->second.replace(its->second.size() - 2, 2, ", " + finding.accept.substr(begin + 2));
    }
  }
  std::string text;
  for (const auto& [item, entry] : entries) text += (text.empty() ? "" : ", ") + entry;
  return text;
}

}  // namespace

namespace {

/// Why its log is refused when somebody accepts it; empty: it may not be.
std::string refusalText(const JudgedRun& run) {
  const auto& findings = run.judgement.findings;
  const auto far = std::ranges::find_if(findings, widensFar);
  if (run.line == 0 || far == findings.end()) return {};
  return "accepting it needs --anyway: " + plainText(widensFarText(*far));
}

}  // namespace

bool widensFar(const RunFinding& finding) {
  return finding.largest && finding.limit > 0 && *finding.largest > kMostWidening * finding.limit;
}

std::string widensFarText(const RunFinding& finding) {
  return fmt::format("{} is {} beyond what was accepted, more than {} times its limit of {}",
                     finding.item, figureText(finding.largest.value_or(0), finding.unit),
                     kMostWidening, figureText(finding.limit, finding.unit));
}

std::vector<std::string> runReasons(const JudgedRun& run, std::size_t most) {
  std::vector<std::string> lines;
  const auto& findings = run.judgement.findings;
  for (std::size_t i = 0; i < std::min(most, findings.size()); ++i) {
    lines.push_back(plainText(findings[i].what));
  }
  if (findings.size() > most)
    lines.push_back(fmt::format("... and {} more", findings.size() - most));
  for (const std::string& change : run.changes) lines.push_back(plainText(change));
  if (const std::string limits = acceptingLimits(run); !limits.empty()) {
    lines.push_back("to accept what moved: limits = { " + plainText(limits) + " }");
  }
  if (std::string refusal = refusalText(run); !refusal.empty()) lines.push_back(std::move(refusal));
  return lines;
}

std::string runText(const JudgedRun& run) {
  std::string text =
      fmt::format("{:<13} {}: {}\n", nameOf(run.verdict), run.name, plainText(run.rule));
  const auto& findings = run.judgement.findings;
  if (findings.size() > 1 || !run.changes.empty() || !acceptingLimits(run).empty() ||
      !refusalText(run).empty()) {
    text += fmt::format("why {}:\n", run.name);
    for (const std::string& line : runReasons(run, 30)) text += fmt::format("    {}\n", line);
  }
  for (const std::string& note : run.judgement.notes) {
    text += fmt::format("note: run {}: {}\n", run.name, plainText(note));
  }
  return text;
}

Json runsJson(const std::vector<JudgedRun>& runs) {
  Json list = Json::array();
  for (const JudgedRun& run : runs) {
    const RunJudgement& judged = run.judgement;
    Json json = {{"name", run.name},
                 {"verdict", nameOf(run.verdict)},
                 {"rule", run.rule},
                 {"log", run.log},
                 {"accepted", run.accepted},
                 {"align", run.align},
                 {"items", judged.items},
                 {"events", judged.events},
                 {"values", judged.values},
                 {"from_ns", judged.from.count()},
                 {"until_ns", judged.until.count()},
                 {"judge_ms", run.judge_ms},
                 {"place", run.place}};
    if (run.line > 0) json["line"] = run.line;
    if (!run.tags.empty()) json["tags"] = run.tags;
    if (!run.pictures.empty()) json["pictures"] = picturesJson(run);
    if (!run.page.empty()) json["page"] = run.page;
    if (!run.log_bytes.empty()) json["log_bytes"] = run.log_bytes;
    json["findings"] = Json::array();
    for (const RunFinding& finding : judged.findings) {
      json["findings"].push_back(findingJson(finding));
    }
    json["coverage"] = coverageJson(judged.coverage);
    json["changes"] = run.changes;
    json["notes"] = judged.notes;
    list.push_back(std::move(json));
  }
  return list;
}

std::vector<JudgedRun> readRunsJson(const nlohmann::json& list) {
  std::vector<JudgedRun> runs;
  if (!list.is_array()) return runs;
  for (const auto& json : list) {
    if (!json.is_object()) continue;
    JudgedRun run;
    run.name = textIn(json, "name");
    if (!isCaseName(run.name)) continue;
    const std::string verdict = textIn(json, "verdict");
    for (const FrameVerdict one : {FrameVerdict::same, FrameVerdict::different,
                                   FrameVerdict::missing, FrameVerdict::incomparable}) {
      if (nameOf(one) == verdict) run.verdict = one;
    }
    run.rule = textIn(json, "rule");
    run.log = textIn(json, "log");
    run.log_bytes = textIn(json, "log_bytes");
    run.accepted = textsIn(json, "accepted");
    run.align = textIn(json, "align");
    run.judge_ms = numberIn<double>(json, "judge_ms");
    run.place = numberIn<std::size_t>(json, "place");
    run.line = numberIn<int>(json, "line");
    run.tags = textsIn(json, "tags");
    run.changes = textsIn(json, "changes");
    RunJudgement& judged = run.judgement;
    judged.comparable = run.verdict == FrameVerdict::same || run.verdict == FrameVerdict::different;
    judged.rule = run.rule;
    judged.accepted = run.accepted.size();
    judged.items = numberIn<std::size_t>(json, "items");
    judged.events = numberIn<std::size_t>(json, "events");
    judged.values = numberIn<std::uint64_t>(json, "values");
    judged.from = Nanoseconds(numberIn<std::int64_t>(json, "from_ns"));
    judged.until = Nanoseconds(numberIn<std::int64_t>(json, "until_ns"));
    judged.notes = textsIn(json, "notes");
    judged.coverage = readCoverage(json);
    for (const auto& picture : arrayIn(json, "pictures")) {
      if (!picture.is_object() || run.pictures.size() == kMaxRunPictures) break;
      run.pictures.push_back({textIn(picture, "device"),
                              Nanoseconds(numberIn<std::int64_t>(picture, "run_ns")),
                              Nanoseconds(numberIn<std::int64_t>(picture, "accepted_ns")),
                              textsIn(picture, "left_out"),
                              {}});
    }
    for (const auto& finding : arrayIn(json, "findings")) {
      if (judged.findings.size() == kMaxReadFindings) break;
      if (finding.is_object()) judged.findings.push_back(readFinding(finding));
    }
    runs.push_back(std::move(run));
  }
  return runs;
}

JunitCase junitRun(const std::string& suite, const JudgedRun& run) {
  JunitCase test;
  test.classname = suite;
  test.name = run.name;
  if (run.line > 0) test.file = suite;
  test.line = run.line;
  test.seconds = run.judge_ms / 1000;
  if (!run.log.empty()) test.properties.emplace_back("log", run.log);
  for (const std::string& log : run.accepted) test.properties.emplace_back("accepted", log);
  if (isFine(run.verdict)) return test;
  test.outcome = run.verdict == FrameVerdict::incomparable ? JunitCase::Outcome::error
                                                           : JunitCase::Outcome::failure;
  test.message = fmt::format("{}: {}", nameOf(run.verdict), run.rule);
  for (const std::string& line : runReasons(run)) test.text += line + "\n";
  return test;
}

}  // namespace rocinante
