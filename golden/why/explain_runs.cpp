#include "golden/why/explain_runs.h"

#include <optional>

#include "golden/why/frame_explainer.h"
#include "golden/why/model_change.h"

namespace rocinante {

void explainRuns(const SuiteSession& session, const SuiteOptions& options,
                 std::vector<JudgedRun>& runs) {
  std::optional<CellBundle> today;
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
    }
    if (hashesOf(*today) == *before) continue;
    run.changes = modelChanges(*before, session.manifest().texts, *today, session.cell());
  }
}

}  // namespace rocinante
