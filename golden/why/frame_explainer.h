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

namespace rocinante {

/// The cell that a session draws, with its files. An error when the cell has faults: it is drawn
/// partially and has no list of files.
Result<CellBundle> collectSessionCell(const SuiteSession& session, const SuiteOptions& options);

/// Explains why frames of a suite differ from their goldens. It looks for the golden's own cell and
/// session in the files named by the suite (when --cell or --log replace them) and in the cell
/// attached to the log; they are used if they reproduce the accepted pixels. Not thread-safe.
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
    std::optional<std::vector<std::string>> changes;  ///< of the model; on demand
  };
  struct Found {
    Candidate* candidate = nullptr;
    FrameRequest request;
    GoldenBasis basis = GoldenBasis::guessed;
  };

  void findCandidates();
  SuiteSession* opened(Candidate& candidate);
  Result<Found> findGolden(const JudgedFrame& judged);
  const std::vector<std::string>& changesSince(Candidate& candidate);
  const std::vector<std::string>& changesSince(const AcceptedPicture& golden);
  CellBundle* bundleToday();

  SuiteSession& now_;
  std::filesystem::path suite_file_;
  SuiteOptions options_;
  bool looked_ = false;
  std::vector<Candidate> candidates_;
  bool collected_ = false;
  std::optional<CellBundle> bundle_today_;                   ///< empty when the cell has faults
  std::map<std::string, std::vector<std::string>> changes_;  ///< by a golden's key of its cell
};

/// Explains failed frames, at most `most` of them.
Status explainFailures(FrameExplainer& explainer, std::vector<JudgedFrame>& frames,
                       std::size_t most = 200);

}  // namespace rocinante
