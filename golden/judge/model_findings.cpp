#include "golden/judge/model_findings.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "core/behaviour/run_judge.h"
#include "core/check/drift/model_drift.h"

namespace rocinante {
namespace {

/// Drift of a model that moves what is judged.
constexpr std::array<std::string_view, 12> kMoving{
    "drift.device-moved",  "drift.device-removed", "drift.joint-added",  "drift.joint-axis",
    "drift.joint-mimic",   "drift.joint-order",    "drift.joint-origin", "drift.joint-parent",
    "drift.joint-removed", "drift.joint-renamed",  "drift.joint-type",   "drift.link-renamed"};

void putInFront(const std::vector<std::string>& of_model, RunJudgement& judged) {
  std::vector<RunFinding> findings;
  for (const std::string& what : of_model) {
    RunFinding& finding = findings.emplace_back();
    finding.kind = RunFinding::Kind::model;
    finding.item = "model";
    finding.what = "model: " + what;
    finding.until_accepted = judged.until;
  }
  if (findings.empty() || !judged.comparable) return;
  judged.findings.insert(judged.findings.begin(), findings.begin(), findings.end());
  judged.rule = runRule(judged);
}

}  // namespace

void addModelFindings(const Cell& then, const Cell& now, RunJudgement& judged) {
  std::vector<std::string> of_model;
  for (const Finding& drift : modelDrift(then, now)) {
    if (std::ranges::find(kMoving, drift.rule) != kMoving.end()) of_model.push_back(drift.text);
  }
  putInFront(of_model, judged);
}

void addUnknownModel(const std::string& why, RunJudgement& judged) {
  putInFront({"it has changed since the log was accepted, and how it was is not known: " + why},
             judged);
}

}  // namespace rocinante
