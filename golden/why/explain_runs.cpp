#include "golden/why/explain_runs.h"

#include <algorithm>
#include <optional>

#include "core/base/plain_text.h"
#include "core/bundle/cell_folder.h"
#include "golden/why/frame_explainer.h"
#include "golden/why/model_change.h"

namespace rocinante {

void explainRuns(const SuiteSession& session, const SuiteOptions& options,
                 std::vector<JudgedRun>& runs) {
  std::optional<CellBundle> today;
  // A suite that draws nothing was opened without geometry, which is compared here.
  std::optional<Cell> now;
  for (JudgedRun& run : runs) {
    if (run.verdict != FrameVerdict::different) continue;
    const auto& accepted = session.manifest().runsOf(run.name);
    const FileHashes* const before =
        accepted.empty() ? nullptr : session.manifest().cellNamed(accepted.front().cell);
    if (before == nullptr) continue;
    if (!today) {
      auto bundle = collectSessionCell(session, options);
      if (!bundle.ok()) return;
      today = std::move(*bundle);
      if (session.suite().cases.empty() && !options.run_pictures) {
        auto whole = loadBundle(*today, "", {});
        if (whole.ok()) now = std::move(*whole);
      }
    }
    if (hashesOf(*today) == *before) continue;
    run.changes = textsOf(
        modelChanges(*before, session.manifest().texts, *today, now ? *now : session.cell()));
    // What moves the model is a finding already.
    std::erase_if(run.changes, [&](const std::string& change) {
      return std::ranges::any_of(run.judgement.findings, [&](const RunFinding& finding) {
        return finding.kind == RunFinding::Kind::model &&
               plainText(finding.what).starts_with("model: " + change);
      });
    });
  }
}

}  // namespace rocinante
