#pragma once

#include "core/cell/cell.h"
#include "golden/run/run_judgement.h"
#include "golden/run/session_track.h"

namespace rocinante {

/// Says in the first findings of turning joints how far that moves the end of their chain, as the
/// other joints of the run are then: "arm/elbow: 4.0° (38.0 mm at tip) beyond what was accepted".
/// `cell` is the one that `run` was made with.
void tellToolEffects(const Cell& cell, const SessionTrack& run, RunJudgement& judged);

}  // namespace rocinante
