#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/parallel_for.h"
#include "core/base/result.h"
#include "core/foreign/recordings/opened_recording.h"
#include "golden/approval/golden_folder.h"
#include "golden/approval/manifest.h"
#include "golden/judge/frame_drawer.h"
#include "golden/judge/judged_frame.h"
#include "golden/suite/suite.h"
#include "golden/suite/suite_plan.h"

namespace rocinante {

struct SuiteOptions : ModelSearch {
  std::optional<std::filesystem::path> cell;  ///< replaces the suite's
  std::optional<std::filesystem::path> log;
  /// `--log` as given: NAME=FILE of a run, or a file, which replaces the suite's.
  std::vector<std::string> logs{};
  FrameSelection selection;
  bool incomplete = false;         ///< judge although a mesh is missing
  bool run_pictures = false;       ///< load geometry also where only runs are selected
  ParallelFor parallel;            ///< for loading the cell; may be empty
  std::function<double()> now_ms;  ///< a steady clock, for the report's timings
  MakeDrawer drawers;              ///< for tests; empty: sceneDrawers()
};

/// A suite with its cell, log and manifest. open() creates no GL context and draws nothing, so the
/// process may fork after it. Not thread-safe.
class SuiteSession {
 public:
  static Result<SuiteSession> open(const std::filesystem::path& suite_file,
                                   const SuiteOptions& options);

  const Suite& suite() const { return *suite_; }
  const Manifest& manifest() const { return manifest_; }
  const GoldenFolder& folder() const { return folder_; }
  const Cell& cell() const { return cell_; }
  /// Why no frame may be judged or approved: a missing mesh. Empty when none is missing or with
  /// `incomplete`.
  const std::string& incomplete() const { return incomplete_; }
  /// content_sha256 of the log; empty without one.
  const std::string& sessionHash() const { return session_hashes_.content; }
  /// decoded_sha256 of the log; empty without decoded packets.
  const std::string& decodedHash() const { return session_hashes_.decoded; }
  /// The log's origin; empty without a log.
  std::optional<LogTime> origin() const { return origin_; }
  /// The suite's log; null without one.
  const OpenedRecording* log() const { return log_ ? &*log_ : nullptr; }
  /// The selected runs in suite order.
  const std::vector<const SuiteRun*>& runs() const { return runs_; }
  /// The log under test of a run: its own of --log, else the suite's; null when there is none.
  const OpenedRecording* logOf(const SuiteRun& run) const;
  /// Options that open a session for this run alone: where the suite names no cell, a log of --log
  /// NAME=FILE that carries one is judged with that. Empty: this session is the run's.
  std::optional<SuiteOptions> optionsOf(const SuiteRun& run, const SuiteOptions& options) const;
  /// The selected frames in suite order; empty only when runs are selected.
  const std::vector<SuiteFrame>& frames() const { return frames_; }
  const std::vector<SuiteFrame>& allFrames() const { return all_frames_; }

  /// The drawer, made by the first call. Valid as long as the session.
  Result<FrameDrawer*> drawer();
  /// A drawer with a fresh context.
  Result<std::unique_ptr<FrameDrawer>> freshDrawer() const { return make_drawer_(); }
  /// The request that draws a frame with a time.
  FrameRequest request(const SuiteFrame& frame) const;
  /// The key of a golden: renderer, size and samples.
  Result<std::string> key(const SuiteCase& suite_case);
  /// The areas of the case's masks in this frame; empty for a case without masks.
  Result<std::optional<CaseAreas>> areas(const SuiteFrame& frame);
  /// What every picture lacks and is judged without all the same: textures that are not there, or
  /// cannot be read, a sentence each. After the first frame was drawn.
  std::vector<std::string> lacks() const;
  /// The devices that a frame with a time judges.
  Result<RunCoverage> coverage(const SuiteFrame& frame);

  /// Draws and judges one frame. A failing frame is drawn twice more, once after another frame and
  /// once in a fresh context, to tell an unstable frame from a different one. Returns an error only
  /// when the renderer fails.
  Result<JudgedFrame> judge(const SuiteFrame& frame);
  /// Draws the frame twice more: the rule that describes its instability, or empty.
  Result<std::string> instability(const SuiteFrame& frame, const Picture& drawn);

 private:
  SuiteSession() : folder_({}, std::filesystem::path()) {}

  std::unique_ptr<Suite> suite_;  // frames point into it
  Manifest manifest_;
  GoldenFolder folder_;
  Cell cell_;
  bool has_own_cell_ = true;  ///< false: it is the one that the suite's log carries
  std::string incomplete_;
  SessionHashes session_hashes_;
  std::optional<LogTime> origin_;
  std::function<double()> now_ms_;
  MakeDrawer make_drawer_;
  std::unique_ptr<FrameDrawer> drawer_;
  std::vector<SuiteFrame> frames_, all_frames_;
  std::vector<const SuiteRun*> runs_;
  std::map<std::string, OpenedRecording, std::less<>> run_logs_;
  std::optional<OpenedRecording> log_;  ///< the suite's
};

}  // namespace rocinante
