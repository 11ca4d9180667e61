#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/parallel_for.h"
#include "core/base/result.h"
#include "golden/approval/golden_folder.h"
#include "golden/approval/manifest.h"
#include "golden/judge/frame_drawer.h"
#include "golden/judge/judged_frame.h"
#include "golden/suite/suite.h"
#include "golden/suite/suite_plan.h"

namespace rocinante {

struct SuiteOptions : ModelSearch {
  std::optional<std::filesystem::path> cell;  ///< in place of the suite's
  std::optional<std::filesystem::path> log;
  FrameSelection selection;
  bool incomplete = false;         ///< judge what there is, though a mesh is missing
  ParallelFor parallel;            ///< for loading the cell; may be empty
  std::function<double()> now_ms;  ///< a steady clock, for the report's timings
  MakeDrawer drawers;              ///< a test's; empty: sceneDrawers()
};

/// A suite with its cell, log and manifest open. Nothing is drawn, and no GL context is made,
/// before it is needed: a process may fork after open(). One thread.
class SuiteSession {
 public:
  static Result<SuiteSession> open(const std::filesystem::path& suite_file,
                                   const SuiteOptions& options);

  const Suite& suite() const { return *suite_; }
  const Manifest& manifest() const { return manifest_; }
  const GoldenFolder& folder() const { return folder_; }
  const Cell& cell() const { return cell_; }
  /// Why no frame may be judged or approved: a mesh is missing. Empty where none is, or where it
  /// was said that this does not matter.
  const std::string& incomplete() const { return incomplete_; }
  /// content_sha256 of the log; empty without one.
  const std::string& sessionHash() const { return session_hash_; }
  /// Of the log; empty without one.
  std::optional<LogTime> origin() const { return origin_; }
  /// The selected frames in order of the suite, never empty; and all that the suite has.
  const std::vector<SuiteFrame>& frames() const { return frames_; }
  const std::vector<SuiteFrame>& allFrames() const { return all_frames_; }

  /// What draws; made by the first call. Valid as long as the session.
  Result<FrameDrawer*> drawer();
  /// A drawer with a context of its own, which nothing was drawn in.
  Result<std::unique_ptr<FrameDrawer>> freshDrawer() const { return make_drawer_(); }
  /// What to ask of a drawer for a frame with a time.
  FrameRequest request(const SuiteFrame& frame) const;
  /// Renderer, size and samples: what a golden is kept under.
  Result<std::string> key(const SuiteCase& suite_case);
  /// Where the case's masks lie in this frame; empty for a case without any.
  Result<std::optional<CaseAreas>> areas(const SuiteFrame& frame);

  /// Draws and judges one. What fails is drawn twice more, once after another frame and once in a
  /// fresh context, so as to tell an unstable frame from a different one. An error only when the
  /// renderer fails.
  Result<JudgedFrame> judge(const SuiteFrame& frame);
  /// The same drawn twice more: the rule that says how it is unstable, or empty.
  Result<std::string> instability(const SuiteFrame& frame, const Picture& drawn);

 private:
  SuiteSession() : folder_({}, {}) {}

  std::unique_ptr<Suite> suite_;  // frames point into it
  Manifest manifest_;
  GoldenFolder folder_;
  Cell cell_;
  std::string incomplete_;
  std::string session_hash_;
  std::optional<LogTime> origin_;
  std::function<double()> now_ms_;
  MakeDrawer make_drawer_;
  std::unique_ptr<FrameDrawer> drawer_;
  std::vector<SuiteFrame> frames_, all_frames_;
};

}  // namespace rocinante
