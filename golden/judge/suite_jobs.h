#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/base/result.h"
#include "golden/judge/suite_session.h"

namespace rocinante {

struct JobOptions {
  int jobs = 1;
  /// Asked between frames; true ends the run, which is then an error. May be empty.
  std::function<bool()> stop;
  /// Told of each frame of session.frames() when all before it are judged. May be empty.
  std::function<void(const JudgedFrame&)> tell;
  std::function<void(std::size_t done, std::size_t of)> progress;  ///< may be empty
};

/// Judges every frame of the session; the answers are in the order of its frames, and do not depend
/// on the number of jobs. Each job goes through the log once, in its order. Above one job each is a
/// process of its own (one llvmpipe has one rasteriser, which several contexts would wait for):
/// nothing may have been drawn by the session yet, and the caller has no other threads. A job that
/// dies leaves the frame that it was at as incomparable, and the others do its work.
Result<std::vector<JudgedFrame>> judgeAll(SuiteSession& session, const JobOptions& options);

/// One job for each processor, but none for fewer than a dozen frames.
int usefulJobs(std::size_t frames, unsigned processors);

}  // namespace rocinante
