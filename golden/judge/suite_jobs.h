#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/base/result.h"
#include "golden/judge/suite_session.h"

namespace rocinante {

struct JobOptions {
  int jobs = 1;
  /// Called between frames; true ends the run with an error. May be empty.
  std::function<bool()> stop;
  /// Called for each frame of session.frames() in order, once all before it are judged. May be
  /// empty.
  std::function<void(const JudgedFrame&)> tell;
  std::function<void(std::size_t done, std::size_t of)> progress;  ///< may be empty
};

/// Judges every frame of the session; results are in frame order and do not depend on the number of
/// jobs. Each job reads the log once, in time order. Two or more jobs run as processes (contexts of
/// one process share llvmpipe's single rasterizer): the session must not have drawn anything yet,
/// and the caller must have no other threads. The current frame of a job that dies becomes
/// incomparable, and the other jobs take over its work.
Result<std::vector<JudgedFrame>> judgeAll(SuiteSession& session, const JobOptions& options);

/// One job per processor, but at least a dozen frames per job.
int usefulJobs(std::size_t frames, unsigned processors);

}  // namespace rocinante
