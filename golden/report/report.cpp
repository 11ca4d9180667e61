#include "golden/report/report.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/atomic_file.h"
#include "core/report/json_text.h"
#include "core/report/junit.h"
#include "golden/report/cause_groups.h"
#include "golden/report/report_runs.h"
#include "golden/why/frame_why.h"

namespace rocinante {
namespace {

/// The explanation as JSON.
Json whyJsonOf(const FrameWhy& why) {
  Json links = Json::array();
  for (const LinkChange& change : why.blame.changes) {
    Json link = {{"device", change.name.device},
                 {"link", change.name.link},
                 {"pixels", change.pixels},
                 {"kind", nameOf(change.kind)},
                 {"text", changeText(change, why.blame.differing)}};
    if (!change.inset.empty()) link["inset"] = change.inset;
    if (!change.camera.empty()) link["camera"] = change.camera;
    if (change.moved_px) link["moved_px"] = *change.moved_px;
    if (change.kind == ChangeKind::color) link["color_shift"] = change.color_shift;
    links.push_back(std::move(link));
  }
  Json state = Json::array();
  for (const StateChange& change : why.state) {
    state.push_back({{"item", change.item}, {"text", change.text}});
  }
  Json json = {{"causes", why.causes},
               {"estimated", why.basis == GoldenBasis::guessed},
               {"differing", why.blame.differing},
               {"links", links},
               {"state", state},
               {"files", why.files}};
  if (!why.common_cause.empty()) json["common_cause"] = why.common_cause;
  return json;
}

Json frameJson(const JudgedFrame& judged) {
  const Comparison& found = judged.comparison;
  Json frame = {
      {"name", judged.frame.name},
      {"verdict", nameOf(judged.verdict)},
      {"rule", judged.rule},
      {"key", judged.key},
      {"pixels", judged.pixels},
      {"inputs", judged.inputs},
      {"tolerance", judged.tolerance.name},
      {"differing", found.differing},
      {"max", found.max},
      {"worst", {{"x", found.worst_x}, {"y", found.worst_y}}},
      {"worst_tile_mean", found.worst_tile_mean},
      {"worst_tile_over", found.worst_tile_over},
      {"pixels_over",
       {{"1", found.over_1}, {"2", found.over_2}, {"8", found.over_8}, {"32", found.over_32}}},
      {"render_ms", judged.render_ms},
      {"judge_ms", judged.judge_ms},
      {"case", judged.frame.case_name},
      {"place", judged.frame.place},
      {"limit_from", judged.limit_from}};
  if (judged.tolerance.limitsPixels()) {
    frame["limits"] = {{"level", judged.tolerance.level}, {"percent", judged.tolerance.percent}};
  } else if (!judged.tolerance.exact) {
    frame["limits"] = {{"tile_mean", judged.tolerance.tile_mean},
                       {"tile_over", judged.tolerance.tile_over}};
  }
  for (std::size_t i = 0; i < judged.masks.size(); ++i) {
    const PictureMask::Part& mask = judged.masks[i];
    frame["masks"].push_back(
        {{"mask", mask.name}, {"pixels", mask.pixels}, {"own", i < judged.own_masks}});
  }
  if (judged.frame.line > 0) frame["line"] = judged.frame.line;
  if (!judged.frame.camera.empty()) frame["camera"] = judged.frame.camera;
  if (!judged.frame.tags.empty()) frame["tags"] = judged.frame.tags;
  if (judged.coverage) frame["coverage"] = coverageJson(*judged.coverage);
  if (!judged.lacks.empty()) frame["lacks"] = judged.lacks;
  if (!judged.expectation.empty()) frame["expectation"] = judged.expectation;
  if (judged.frame.time) frame["log_time_ns"] = judged.frame.time->time_since_epoch().count();
  if (judged.golden) {
    frame["golden"] = {{"key", judged.golden->key},
                       {"picture", judged.golden->picture},
                       {"pixels", judged.golden->pixels},
                       {"inputs_equal", judged.golden->inputs == judged.inputs},
                       {"session_equal", judged.golden->session == judged.session},
                       {"accepted_by", judged.golden->accepted_by},
                       {"accepted_at", judged.golden->accepted_at},
                       {"reason", judged.golden->reason}};
    if (judged.golden->coverage) frame["golden"]["coverage"] = *judged.golden->coverage;
    if (!judged.golden->decoded.empty() || !judged.decoded.empty()) {
      frame["golden"]["decoded_equal"] = judged.golden->decoded == judged.decoded;
    }
  }
  if (judged.why) frame["why"] = whyJsonOf(*judged.why);
  if (!judged.page.empty()) frame["page"] = judged.page;
  return frame;
}

JunitCase junitCase(const SuiteReport& report, const std::vector<CauseGroup>& groups,
                    const JudgedFrame& judged) {
  JunitCase test;
  test.classname = report.suite;
  test.name = judged.frame.name;
  if (judged.frame.line > 0) test.file = report.suite;
  test.line = judged.frame.line;
  test.seconds = (judged.render_ms + judged.judge_ms) / 1000;
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) test.properties.emplace_back(name, value);
  };
  add("key", judged.key);
  if (judged.golden) {
    add("golden key", judged.golden->key);
    add("tier", judged.tolerance.name);
  }
  if (isFine(judged.verdict)) return test;
  test.outcome = judged.verdict == FrameVerdict::incomparable ? JunitCase::Outcome::error
                                                              : JunitCase::Outcome::failure;
  const std::string cause = causeSentence(groups, judged);
  test.message = fmt::format("{}: {}", nameOf(judged.verdict), cause.empty() ? judged.rule : cause);
  if (!cause.empty()) test.text += judged.rule + "\n";
  if (judged.why) {
    for (const std::string& line : whyLines(*judged.why)) test.text += line + "\n";
  }
  return test;
}

}  // namespace

std::size_t SuiteReport::count(FrameVerdict verdict) const {
  return static_cast<std::size_t>(
      std::ranges::count(frames, verdict, [](const JudgedFrame& frame) { return frame.verdict; }));
}

Verdict SuiteReport::verdict() const {
  std::size_t fine = 0;
  std::size_t incomparable = 0;
  const auto add = [&](FrameVerdict verdict) {
    fine += isFine(verdict) ? 1 : 0;
    incomparable += verdict == FrameVerdict::incomparable ? 1 : 0;
  };
  for (const JudgedFrame& frame : frames) add(frame.verdict);
  for (const JudgedRun& run : runs) add(run.verdict);
  const std::size_t all = frames.size() + runs.size();
  if (all > 0 && fine == all) return Verdict::same;
  const bool no = all > fine + incomparable;
  return no ? Verdict::different : Verdict::incomparable;
}

bool canApprove(const JudgedFrame& judged) {
  const bool may = judged.verdict == FrameVerdict::different ||
                   judged.verdict == FrameVerdict::missing ||
                   judged.verdict == FrameVerdict::unexpected;
  return may && !judged.pixels.empty() && judged.drawn.has_value();
}

bool canApproveRun(const JudgedRun& run) {
  const bool may = run.verdict == FrameVerdict::different || run.verdict == FrameVerdict::missing;
  return may && !run.log_bytes.empty() && std::ranges::none_of(run.judgement.findings, widensFar);
}

std::string reportJson(const SuiteReport& report) {
  Json root;
  root["format"] = 1;
  root["verdict"] = nameOf(report.verdict());
  root["suite"] = report.suite;
  root["cell"] = report.cell;
  root["log"] = report.log;
  root["session"] = report.session;
  if (!report.decoded.empty()) root["decoded"] = report.decoded;
  root["renderer"] = report.renderer;
  Json& counts = root["counts"] = Json::object();
  for (const FrameVerdict verdict : kFrameVerdicts) {
    counts[std::string(nameOf(verdict))] = report.count(verdict);
  }
  root["made_at"] = report.made_at;
  root["run_command"] = report.run_command;
  root["approve_command"] = report.approve_command;
  const auto add = [&](const char* key, const std::string& command) {
    if (!command.empty()) root[key] = command;
  };
  add("run_one_command", report.run_one_command);
  add("approve_one_command", report.approve_one_command);
  add("approve_from_command", report.approve_from_command);
  if (!report.cell_files.empty()) root["cell_files"] = report.cell_files;
  if (report.shards > 1) root["shard"] = {{"number", report.shard}, {"of", report.shards}};
  root["notes"] = report.notes;
  root["frames"] = Json::array();
  for (const JudgedFrame& judged : report.frames) root["frames"].push_back(frameJson(judged));
  if (!report.runs.empty()) root["runs"] = runsJson(report.runs);
  return jsonText(root);
}

std::string reportJunit(const SuiteReport& report) {
  JunitSuite suite;
  suite.name = report.suite;
  const std::vector<CauseGroup> groups = causeGroups(report.frames);
  for (const JudgedFrame& judged : report.frames) {
    suite.cases.push_back(junitCase(report, groups, judged));
  }
  for (const JudgedRun& run : report.runs) suite.cases.push_back(junitRun(report.suite, run));
  return junitXml(suite);
}

}  // namespace rocinante
