#pragma once

#include "core/base/parallel_for.h"
#include "golden/run/motion_judge.h"

namespace rocinante {

/// Judges all devices that some session has, and adds what it judged and found to `judged`. Returns
/// the motion that is fastest beside its limit. `parallel` may be empty.
FastMotion judgeDevices(const RunTimes& times, const ParallelFor& parallel, RunJudgement& judged);

}  // namespace rocinante
