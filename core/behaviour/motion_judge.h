#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/parallel_for.h"
#include "core/behaviour/column_samples.h"
#include "core/behaviour/run_judgement.h"
#include "core/behaviour/run_spec.h"
#include "core/behaviour/session_track.h"
#include "core/behaviour/time_map.h"

namespace rocinante {

/// What the judges of one run share. Times are nanoseconds since the start of the first accepted
/// session, on its time line. Borrows everything but the maps.
struct RunTimes {
  const RunSpec& spec;
  const std::vector<const SessionTrack*>& accepted;
  const SessionTrack& run;
  std::vector<TimeMap> accepted_maps;  ///< from the first accepted session to each
  TimeMap run_map;

  const SessionTrack& first() const { return *accepted.front(); }
  /// The accepted ones, then the run.
  template <class Visit>
  void eachSession(Visit visit) const {
    for (const SessionTrack* track : accepted) visit(*track);
    visit(run);
  }
  /// How much earlier or later something may come: `event_ms`, and what a warp resolves.
  std::int64_t reachOf(const RunLimits& limits) const;
  std::int64_t end() const { return (first().end - first().start).count(); }
  LogTime inAccepted(std::size_t session, std::int64_t time) const {
    return accepted_maps[session].inRun(first().start + Nanoseconds(time));
  }
  LogTime inRun(std::int64_t time) const {
    return run_map.inRun(first().start + Nanoseconds(time));
  }
  /// Where the run's log begins and ends.
  std::int64_t runBegin() const { return onLine(run.start); }
  std::int64_t runEnd() const { return onLine(run.end); }
  std::int64_t onLine(LogTime of_run) const {
    return (run_map.inAccepted(of_run) - first().start).count();
  }
  Nanoseconds sinceOrigin(std::int64_t time) const {
    return first().start + Nanoseconds(time) - first().origin;
  }
  /// Since the run's origin; within its log.
  Nanoseconds sinceRunOrigin(std::int64_t time) const;
  /// "4.120 s (accepted 4.118 s)"
  std::string bothTimes(std::int64_t time) const;
  /// A finding that holds throughout.
  RunFinding findingOfAll(RunFinding::Kind kind, std::string item) const;
};

/// How far a joint moves within `event_ms`: what is smaller than that may hide there.
struct FastMotion {
  std::string item, unit;
  double figure = 0;  ///< in the unit
  double times_limit = 0;
  std::int64_t at = 0;
};

struct ColumnOutcome {
  std::uint64_t values = 0;  ///< that were compared
  FastMotion fastest;
};

/// Judges what the accepted sessions have of a device, by columns. Holds the times of all its
/// packets, eight bytes each. Columns may be judged by several threads.
class DeviceMotion {
 public:
  DeviceMotion(const RunTimes& times, std::string device);

  /// A joint's value, or position and turn of a pose. Appends to `findings` what is beyond its
  /// limit.
  ColumnOutcome judge(const TrackColumn& column, std::vector<RunFinding>& findings) const;

 private:
  const RunTimes& times_;
  std::string device_;
  /// By session, the run last, and by series.
  std::vector<std::vector<std::vector<std::int64_t>>> series_times_;
};

/// Judges a joint's value, or position and turn of a pose, by the two rules of docs/decisions/041.
/// Appends to `findings` the measures that are beyond their limit.
ColumnOutcome judgeColumn(const RunTimes& times, const std::string& item, const TrackColumn& column,
                          const std::vector<ColumnSamples>& accepted, const ColumnSamples& run,
                          std::vector<RunFinding>& findings);

/// Judges how often packets state a device, in stretches of a second.
void judgeRate(const RunTimes& times, const std::string& device, std::vector<RunFinding>& findings);

/// Judges how often packets state each signal that all sessions have, where it is stated regularly:
/// a signal that is stated on changes alone has no rhythm. A device's own finding tells of its
/// signals. `parallel` may be empty.
void judgeSignalRates(const RunTimes& times, const ParallelFor& parallel, RunJudgement& judged);

/// Devices are judged together up to this many packets in all sessions: 64 MB of times.
inline constexpr std::uint64_t kBatchRows = 8'000'000;

/// Judges all devices that some session has, and adds what it judged and found to `judged`. Returns
/// the motion that is fastest beside its limit. `parallel` may be empty.
FastMotion judgeDevices(const RunTimes& times, const ParallelFor& parallel, RunJudgement& judged,
                        std::uint64_t batch_rows = kBatchRows);

/// How far a signal's number may leave the band where no limit in its unit is written: a share of
/// the range that the accepted sessions have together, and what lies in their noise.
struct LearntLimit {
  double limit = 0, range = 0;
  /// Nothing that the accepted sessions have would be different anywhere.
  bool isBlind() const { return range > 0 && limit >= range; }
};
LearntLimit learntLimit(const RunLimits& limits, const std::vector<ColumnSamples>& accepted);

/// Judges the numbers of all signals that some session has, each as a column of its own, and adds
/// what it judged and found to `judged`. `parallel` may be empty.
void judgeNumbers(const RunTimes& times, const ParallelFor& parallel, RunJudgement& judged);

/// Of the bends in time; of very long sessions a multiple of it.
inline constexpr Nanoseconds kWarpStep = std::chrono::milliseconds(20);

/// `map` bent so that the motion of `other` fits that of `first` best: at each time by at most
/// `most` to either side, never backwards, at most twice as fast, and not at all at the map's knots
/// when they are events (`keeps_knots`; otherwise not at the start). All joints bend together, so
/// one that alone is late stays late.
TimeMap warpedMap(const SessionTrack& first, const SessionTrack& other, const TimeMap& map,
                  bool keeps_knots, Nanoseconds most);

}  // namespace rocinante
