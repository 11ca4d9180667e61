#pragma once

#include <string>
#include <vector>

#include "core/base/parallel_for.h"
#include "core/behaviour/motion_judge.h"
#include "core/behaviour/run_judgement.h"
#include "core/behaviour/run_spec.h"
#include "core/behaviour/session_track.h"
#include "core/behaviour/time_map.h"
#include "core/cell/cell.h"
#include "core/session/event_alignment.h"

namespace rocinante {

/// Compares a session with the accepted ones (docs/golden-suites.md, "Runs"), over the whole length
/// of the first: what each packet states with what the other side has about then. `accepted` has at
/// least one.
/// Not comparable when `spec` aligns by events and they have none in common. Pure, whatever
/// `parallel` is; it may be empty. One that gives up, and runs no task any more, ends this soon:
/// the judgement is worth nothing then.
RunJudgement judgeRun(const RunSpec& spec, const std::vector<const SessionTrack*>& accepted,
                      const SessionTrack& run, const ParallelFor& parallel = {});

/// The sentence of the findings, or of what was within the limits.
std::string runRule(const RunJudgement& judged);

/// Judges something that is stated rather than moved: visibility, colour, presence, a carrier, a
/// drawing. It must be, at each time, as in one of the accepted sessions about then, and what all
/// of them have must be in the run about then.
void judgeFact(const RunTimes& times, const std::string& fact, std::vector<RunFinding>& findings);

/// The events of a run beside those of the accepted sessions.
struct RunEvents {
  std::vector<EventAlignment> accepted;  ///< each of the further accepted ones with the first
  EventAlignment run;                    ///< of the run with the first accepted one
  std::vector<TimeMap> accepted_maps;    ///< the first, too
  TimeMap run_map;
  std::vector<RunFinding> findings;
};

/// Aligns and judges: missing, extra, out of order, and late or early. With RunAlign::origin a time
/// is judged since the origin, otherwise since the event before: what delays one event delays all
/// that follow, and only the first is named. `accepted` has at least one session.
RunEvents judgeEvents(const RunSpec& spec, const std::vector<const SessionTrack*>& accepted,
                      const SessionTrack& run);

/// Says in the first findings of turning joints how far that moves the end of their chain, as the
/// other joints of the run are then: "arm/elbow: 4.0° (38.0 mm at tip) beyond what was accepted".
/// `cell` is the one that `run` was made with.
void tellToolEffects(const Cell& cell, const SessionTrack& run, RunJudgement& judged);

}  // namespace rocinante
