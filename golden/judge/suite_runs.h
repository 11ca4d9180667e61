#pragma once

#include <functional>
#include <string>

#include "core/base/result.h"
#include "core/behaviour/track_cache.h"
#include "golden/judge/judged_run.h"
#include "golden/judge/suite_session.h"

namespace rocinante {

/// The cell that a log was accepted with.
struct AcceptedCell {
  const Cell* cell = nullptr;  ///< null: its links are where today's are, or it is unknown
  std::string unknown;         ///< a clause: why a cell that has changed cannot be put back
};

struct RunOptions {
  /// Called before each log by the threads of `parallel`; true ends the run with an error. May be
  /// empty.
  std::function<bool()> stop;
  std::function<double()> now_ms;                             ///< a steady clock
  TrackCache cache{};                                         ///< of accepted logs
  std::function<AcceptedCell(const AcceptedRun&)> cell_of{};  ///< may be empty: the session's
  ParallelFor parallel{};                                     ///< may be empty
};

/// Judges one run of the session's suite, as judgeRuns() does.
Result<JudgedRun> judgeOneRun(const SuiteSession& session, const SuiteRun& run,
                              const RunOptions& options);

/// Why the log under test could not be judged against itself, so that it must not be accepted: a
/// sentence; empty when it can.
Result<std::string> judgeAlone(const SuiteSession& session, const SuiteRun& run);

/// Judges some of the session's runs: each log is read once. Errors only when stopped: a log that
/// cannot be judged makes its run incomparable.
Result<std::vector<JudgedRun>> judgeRuns(const SuiteSession& session,
                                         const std::vector<const SuiteRun*>& runs,
                                         const RunOptions& options);

}  // namespace rocinante
