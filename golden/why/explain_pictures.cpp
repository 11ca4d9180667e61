#include "golden/why/explain_pictures.h"

#include <algorithm>
#include <optional>

#include "core/base/plain_text.h"
#include "core/bundle/attached_cell.h"
#include "core/bundle/cell_folder.h"
#include "core/log/log_reader.h"
#include "golden/why/file_change.h"
#include "golden/why/frame_explainer.h"
#include "golden/why/model_change.h"
#include "golden/why/view_blame.h"

namespace rocinante {
namespace {

/// The cell that an accepted log carries, when a file is not as it was whose text nobody keeps.
std::optional<CellBundle> carriedCell(const SuiteSession& session, const AcceptedRun& accepted,
                                      const FileHashes& before, const FileHashes& today) {
  const auto is_needed = [&](const auto& file) {
    const auto now = today.find(file.first);
    return now != today.end() && now->second != file.second && !isRecordedText(file.first);
  };
  if (std::ranges::none_of(before, is_needed)) return std::nullopt;
  const auto log = LogReader::open(session.folder().fileOf(accepted));
  if (!log.ok()) return std::nullopt;
  auto carried = readAttachedCell(*log);
  return carried.ok() ? std::move(*carried) : std::nullopt;
}

}  // namespace

std::string cameraName(const DrawableSide& side) {
  if (!side.request.camera.empty()) return side.request.camera;
  const auto& cameras = side.drawer.cell().cameras;
  return cameras.empty() ? std::string() : cameras.front().name;
}

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

Result<FrameWhy> explainBoth(const Picture& golden, const DrawableSide& golden_side,
                             const Picture& frame, const DrawableSide& frame_side) {
  const auto golden_identity = golden_side.drawer.identity(golden_side.request);
  if (!golden_identity.ok()) return golden_identity.error();
  const auto frame_identity = frame_side.drawer.identity(frame_side.request);
  if (!frame_identity.ok()) return frame_identity.error();
  const auto golden_views = golden_side.drawer.views(golden_side.request);
  if (!golden_views.ok()) return golden_views.error();
  const auto frame_views = frame_side.drawer.views(frame_side.request);
  if (!frame_views.ok()) return frame_views.error();
  const auto golden_state = golden_side.drawer.state(golden_side.request);
  if (!golden_state.ok()) return golden_state.error();
  const auto frame_state = frame_side.drawer.state(frame_side.request);
  if (!frame_state.ok()) return frame_state.error();
  const Moment golden_moment{golden_side.drawer.cell(), *golden_state};
  const Moment frame_moment{frame_side.drawer.cell(), *frame_state};
  FrameWhy why;
  why.basis = GoldenBasis::redrawn;
  why.blame =
      blameViews({golden, golden_identity->frame}, *golden_views, {frame, frame_identity->frame},
                 *frame_views, movedLinks(golden_moment, frame_moment));
  why.state = stateChanges(golden_moment, frame_moment, cameraName(frame_side));
  findCauses({}, {}, {}, why);
  return why;
}

Result<FrameWhy> explainByGuess(const Picture& golden, const Picture& frame,
                                const DrawableSide& frame_side) {
  const auto identity = frame_side.drawer.identity(frame_side.request);
  if (!identity.ok()) return identity.error();
  const auto views = frame_side.drawer.views(frame_side.request);
  if (!views.ok()) return views.error();
  FrameWhy why;
  why.blame = guessViews(golden, {frame, identity->frame}, *views, frame_side.drawer.cell());
  findCauses({}, {}, {}, why);
  return why;
}

}  // namespace rocinante
