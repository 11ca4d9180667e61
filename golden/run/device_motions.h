#pragma once

#include <cstdint>

#include "core/base/parallel_for.h"
#include "golden/run/motion_judge.h"

namespace rocinante {

/// Devices are judged together up to this many packets in all sessions: 64 MB of times.
inline constexpr std::uint64_t kBatchRows = 8'000'000;

/// Judges all devices that some session has, and adds what it judged and found to `judged`. Returns
/// the motion that is fastest beside its limit. `parallel` may be empty.
FastMotion judgeDevices(const RunTimes& times, const ParallelFor& parallel, RunJudgement& judged,
                        std::uint64_t batch_rows = kBatchRows);

}  // namespace rocinante
