#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/base/parallel_for.h"
#include "core/behaviour/run_spec.h"
#include "core/behaviour/session_track.h"

namespace rocinante {

/// Limits with which recordings of one scenario accept each other.
struct LimitSuggestion {
  double event_ms = 0;                                       ///< 0: the run's own is enough
  std::map<std::string, OwnLimits, std::less<>> own_limits;  ///< by item
  std::set<std::string> beyond;  ///< sentences of findings that no limit accepts
  std::size_t recordings = 0;
  std::size_t alarms_before = 0;  ///< that differ from all others with the run's own limits
  std::size_t alarms = 0;         ///< with limits that the others alone suggest

  /// Share of further recordings that will be called different: the rule of succession.
  double expected() const {
    return static_cast<double>(alarms + 1) / static_cast<double>(recordings + 2);
  }
  /// How many recordings more bring that to one in twenty, if no alarm comes with them.
  std::size_t wanted() const;
  /// The run's limits with these in addition.
  RunSpec appliedTo(RunSpec spec) const;
  /// `limits = { ... }`, with what `spec` has; empty when nothing is to be written.
  std::string toml(const RunSpec& spec) const;
};

/// Each recording is judged beside all others; what it leaves them by, and as much again, is
/// the limit. `sessions`: at least three, made with linksToJudge(spec). `parallel` may be empty.
LimitSuggestion suggestLimits(const RunSpec& spec, const std::vector<const SessionTrack*>& sessions,
                              const ParallelFor& parallel = {});

}  // namespace rocinante
