#pragma once

#include <vector>

#include "core/base/parallel_for.h"
#include "golden/run/run_judgement.h"
#include "golden/run/run_spec.h"
#include "golden/run/session_track.h"

namespace rocinante {

/// Compares a session with the accepted ones (docs/golden-suites.md, "Runs"), over the whole length
/// of the first: what each packet states with what the other side has about then. `accepted` has at
/// least one.
/// Not comparable when `spec` aligns by events and they have none in common. Pure, whatever
/// `parallel` is; it may be empty.
RunJudgement judgeRun(const RunSpec& spec, const std::vector<const SessionTrack*>& accepted,
                      const SessionTrack& run, const ParallelFor& parallel = {});

/// The sentence of the findings, or of what was within the limits.
std::string runRule(const RunJudgement& judged);

}  // namespace rocinante
