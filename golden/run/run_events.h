#pragma once

#include <vector>

#include "core/session/event_alignment.h"
#include "golden/run/run_judgement.h"
#include "golden/run/run_spec.h"
#include "golden/run/session_track.h"
#include "golden/run/time_map.h"

namespace rocinante {

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

}  // namespace rocinante
