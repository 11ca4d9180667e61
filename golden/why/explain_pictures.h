#pragma once

#include <vector>

#include "core/base/result.h"
#include "golden/judge/frame_drawer.h"
#include "golden/judge/judged_run.h"
#include "golden/judge/suite_session.h"
#include "golden/why/frame_why.h"

namespace rocinante {

/// Sets JudgedRun::changes of runs that are not as accepted: what changed in the model or cell
/// since their first log was accepted, as modelChanges() says it.
void explainRuns(const SuiteSession& session, const SuiteOptions& options,
                 std::vector<JudgedRun>& runs);

/// One side of a comparison that can be drawn. Borrowed.
struct DrawableSide {
  FrameDrawer& drawer;
  FrameRequest request;
};

/// The camera that it is seen by: the cell's first where the request names none; empty when the
/// cell has none.
std::string cameraName(const DrawableSide& side);

/// Explains with both sides known: the owners of differing pixels and the differences of the
/// sessions.
Result<FrameWhy> explainBoth(const Picture& golden, const DrawableSide& golden_side,
                             const Picture& frame, const DrawableSide& frame_side);
/// Explains with only the frame's side known.
Result<FrameWhy> explainByGuess(const Picture& golden, const Picture& frame,
                                const DrawableSide& frame_side);

}  // namespace rocinante
