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

/// The cell that a session draws, with its files; an error where it has faults: a cell with errors
/// is drawn as far as it goes, and has no list of files.
Result<CellBundle> collectSessionCell(const SuiteSession& session, const SuiteOptions& options);

/// Says why frames of a suite are not their goldens. The golden's own cell and session are looked
/// for in what the suite names where --cell or --log stand in its place, and in the cell that the
/// log carries; they count when they draw the accepted pixels again. One thread, as its session.
class FrameExplainer {
 public:
  /// `session` is borrowed; it was opened of `suite_file` with `options`.
  FrameExplainer(SuiteSession& session, std::filesystem::path suite_file, SuiteOptions options);

  /// Null where there are no two pictures of one size. An error only when the renderer fails.
  Result<std::shared_ptr<const FrameWhy>> explain(const JudgedFrame& judged);

 private:
  /// Something that the goldens may have been drawn of.
  struct Candidate {
    SuiteOptions options;
    std::unique_ptr<SuiteSession> session;  ///< opened when first needed
    bool is_unusable = false;
    std::optional<std::vector<std::string>> changes;  ///< of the model since, once asked for
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
  std::optional<CellBundle> bundle_today_;                   ///< empty where the cell has faults
  std::map<std::string, std::vector<std::string>> changes_;  ///< by a golden's key of its cell
};

/// Explains those that failed, where there is something to explain; at most `most` of them, since
/// nobody reads more.
Status explainFailures(FrameExplainer& explainer, std::vector<JudgedFrame>& frames,
                       std::size_t most = 200);

}  // namespace rocinante
