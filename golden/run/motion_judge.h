#pragma once

#include <vector>

#include "golden/run/aligned_grid.h"
#include "golden/run/run_judgement.h"
#include "golden/run/run_spec.h"

namespace rocinante {

/// What the judges of one run share. Borrows everything.
struct RunGrids {
  const RunSpec& spec;
  const std::vector<const SessionTrack*>& accepted;
  const SessionTrack& run;
  std::vector<AlignedGrid> accepted_grids;
  AlignedGrid run_grid;

  const SessionTrack& first() const { return *accepted.front(); }
  LogTime firstTime(std::size_t sample) const {
    return first().start + first().step * static_cast<std::int64_t>(sample);
  }
  Nanoseconds sinceOrigin(std::size_t sample) const { return firstTime(sample) - first().origin; }
  /// Since the run's origin; within its log.
  Nanoseconds inRun(std::size_t sample) const;
  /// Samples that a value may come earlier or later.
  std::size_t reachOf(const RunLimits& limits) const;
  /// "4.120 s (accepted 4.118 s)"
  std::string bothTimes(std::size_t sample) const;
};

/// Judges one column of a device: a joint's value, or position and turn of a pose. Returns how many
/// measures were judged; appends to `findings` those beyond their limit.
std::size_t judgeColumn(const RunGrids& grids, const std::string& device, const TrackColumn& column,
                        std::vector<RunFinding>& findings);

/// Judges how often packets state a device, in stretches of a second.
void judgeRate(const RunGrids& grids, const std::string& device, std::vector<RunFinding>& findings);

}  // namespace rocinante
