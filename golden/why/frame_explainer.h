#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "golden/judge/suite_session.h"
#include "golden/why/explain_pictures.h"
#include "golden/why/file_change.h"
#include "golden/why/model_change.h"

namespace rocinante {

/// The cell that a session draws, with its files. An error when the cell has faults: it is drawn
/// partially and has no list of files.
Result<CellBundle> collectSessionCell(const SuiteSession& session, const SuiteOptions& options);

/// Explains why frames of a suite differ from their goldens. It looks for the golden's own cell and
/// session in the files named by the suite (when --cell or --log replace them), in the cell
/// attached to the log and in the texts of the cell that the manifest keeps; they are used if they
/// reproduce the accepted pixels. Not thread-safe.
class FrameExplainer {
 public:
  /// `session` is borrowed; it must have been opened from `suite_file` with `options`.
  FrameExplainer(SuiteSession& session, std::filesystem::path suite_file, SuiteOptions options);

  /// Null without two pictures of one size. An error only when the renderer fails.
  Result<std::shared_ptr<const FrameWhy>> explain(const JudgedFrame& judged);

 private:
  /// A cell and session that goldens may have been drawn from.
  struct Candidate {
    SuiteOptions options;
    std::unique_ptr<SuiteSession> session;  ///< opened when first needed
    bool is_unusable = false;
    std::optional<CellBundle> bundle;     ///< the session's cell; empty when it has faults
    std::optional<ModelChanges> changes;  ///< of the model; on demand
  };
  /// Draws the cell that a golden was accepted with and a log.
  struct Rebuilt {
    std::optional<Cell> cell;
    std::map<std::string, std::unique_ptr<FrameDrawer>> drawers;  ///< by the log's file
  };
  struct Found {
    FrameDrawer* drawer = nullptr;
    const Candidate* candidate = nullptr;  ///< null: rebuilt
    FrameRequest request;
    GoldenBasis basis = GoldenBasis::guessed;
  };

  void findCandidates();
  SuiteSession* opened(Candidate& candidate);
  Result<Found> findGolden(const JudgedFrame& judged);
  Result<Found> findRebuilt(const JudgedFrame& judged);
  Result<Found> findByCamera(const JudgedFrame& judged);
  /// Null when its texts are not known, or are today's.
  Rebuilt* rebuilt(const AcceptedPicture& golden);
  /// Whether its cell has the files that the golden was accepted with; true when unknown.
  bool hasFilesOf(const Candidate& candidate, const AcceptedPicture& golden) const;
  const ModelChanges& changesSince(Candidate& candidate);
  const ModelChanges& changesSince(const AcceptedPicture& golden);
  CellBundle* bundleToday();

  SuiteSession& now_;
  std::filesystem::path suite_file_;
  SuiteOptions options_;
  bool looked_ = false;
  std::vector<Candidate> candidates_;
  std::size_t in_vain_ = 0;  ///< frames for which findByCamera() found nothing
  bool collected_ = false;
  std::optional<CellBundle> bundle_today_;       ///< empty when the cell has faults
  std::map<std::string, ModelChanges> changes_;  ///< by a golden's key of its cell
  std::map<std::string, Rebuilt> rebuilt_;       ///< by the same
};

/// Explains failed frames, at most `most` of them.
Status explainFailures(FrameExplainer& explainer, std::vector<JudgedFrame>& frames,
                       std::size_t most = 200);

}  // namespace rocinante
