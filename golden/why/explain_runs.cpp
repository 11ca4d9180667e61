#include "golden/why/explain_runs.h"

#include <algorithm>
#include <optional>

#include "core/base/plain_text.h"
#include "core/bundle/attached_cell.h"
#include "core/bundle/cell_folder.h"
#include "core/log/log_reader.h"
#include "golden/why/file_change.h"
#include "golden/why/frame_explainer.h"
#include "golden/why/model_change.h"

namespace rocinante {
namespace {

/// The cell that an accepted log carries, when a file is not as it was whose text nobody keeps.
std::optional<CellBundle> carriedCell(const SuiteSession& session, const AcceptedRun& accepted,
                                      const FileHashes& before, const FileHashes& today) {
  const auto is_needed = [&](const auto& file) {
    const auto now = today.find(file.first);
    return now != today.end() && now->second != file.second && !isToldText(file.first);
  };
  if (std::ranges::none_of(before, is_needed)) return std::nullopt;
  const auto log = LogReader::open(session.folder().fileOf(accepted));
  if (!log.ok()) return std::nullopt;
  auto carried = readAttachedCell(*log);
  return carried.ok() ? std::move(*carried) : std::nullopt;
}

}  // namespace

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
    const FileHashes files_today = hashesOf(*today);
    if (files_today == *before) continue;
    const auto carried = carriedCell(session, accepted.front(), *before, files_today);
    run.changes =
        textsOf(modelChanges(*before, session.manifest().texts, *today, now ? *now : session.cell(),
                             carried ? contentsOf(*carried) : FileContents{}));
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
