#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/behaviour/run_judgement.h"
#include "golden/judge/judged_frame.h"

namespace rocinante {

/// A device where a run left what was accepted, with the accepted session as a clear ghost.
struct RunPicture {
  std::string device;
  Nanoseconds at_run{0}, at_accepted{0};  ///< since the origin of each session
  std::vector<std::string> left_out;      ///< devices that would cover it
  Picture picture;
};

/// A judged run of a suite with all data for reports.
struct JudgedRun {
  std::string name;
  std::vector<std::string> tags;
  std::size_t place = 0;  ///< among all runs of the suite
  int line = 0;           ///< in the suite's file
  /// same, different, missing (no log was accepted yet) or incomparable.
  FrameVerdict verdict = FrameVerdict::incomparable;
  std::string rule;  ///< the sentence that decided
  std::string log;   ///< under test
  std::string align;
  std::vector<std::string> accepted;  ///< file names, oldest first
  RunJudgement judgement;
  std::vector<RunPicture> pictures{};  ///< only for a report's folder
  std::string page{};  ///< "lift.run.html": the session's, beside the report; or empty
  std::vector<std::string> changes;  ///< of the model since the first log was accepted
  double judge_ms = 0;
  /// XXH3-128 of the log under test, where it may be accepted by a list; else empty.
  std::string log_bytes{};
  std::shared_ptr<const std::string> log_copy{};  ///< the log itself, for a report's folder
};

}  // namespace rocinante
