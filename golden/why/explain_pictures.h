#pragma once

#include "core/base/result.h"
#include "golden/judge/frame_drawer.h"
#include "golden/why/frame_why.h"

namespace rocinante {

/// One side of a comparison that can be drawn. Borrowed.
struct DrawableSide {
  FrameDrawer& drawer;
  FrameRequest request;
};

/// Explains with both sides known: the owners of differing pixels and the differences of the
/// sessions.
Result<FrameWhy> explainBoth(const Picture& golden, const DrawableSide& golden_side,
                             const Picture& frame, const DrawableSide& frame_side);
/// Explains with only the frame's side known.
Result<FrameWhy> explainByGuess(const Picture& golden, const Picture& frame,
                                const DrawableSide& frame_side);

}  // namespace rocinante
