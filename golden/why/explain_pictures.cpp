#include "golden/why/explain_pictures.h"

#include "golden/why/model_change.h"
#include "golden/why/view_blame.h"

namespace rocinante {
namespace {

std::string cameraName(const DrawableSide& side) {
  if (!side.request.camera.empty()) return side.request.camera;
  const auto& cameras = side.drawer.cell().cameras;
  return cameras.empty() ? std::string() : cameras.front().name;
}

}  // namespace

Result<FrameWhy> explainBoth(const Picture& golden, const DrawableSide& golden_side,
                             const Picture& frame, const DrawableSide& frame_side) {
  const auto golden_identity = golden_side.drawer.identity(golden_side.request);
  if (!golden_identity.ok()) return golden_identity.error();
  const auto frame_identity = frame_side.drawer.identity(frame_side.request);
  if (!frame_identity.ok()) return frame_identity.error();
  const auto golden_views = golden_side.drawer.views(golden_side.request);
  if (!golden_views.ok()) return golden_views.error();
  const auto frame_views = frame_side.drawer.views(frame_side.request);
  if (!frame_views.ok()) return frame_views.error();
  const auto golden_state = golden_side.drawer.state(golden_side.request);
  if (!golden_state.ok()) return golden_state.error();
  const auto frame_state = frame_side.drawer.state(frame_side.request);
  if (!frame_state.ok()) return frame_state.error();
  const Moment golden_moment{golden_side.drawer.cell(), *golden_state};
  const Moment frame_moment{frame_side.drawer.cell(), *frame_state};
  FrameWhy why;
  why.basis = GoldenBasis::redrawn;
  why.blame =
      blameViews({golden, golden_identity->frame}, *golden_views, {frame, frame_identity->frame},
                 *frame_views, movedLinks(golden_moment, frame_moment));
  why.state = stateChanges(golden_moment, frame_moment, cameraName(frame_side));
  findCauses({}, {}, why);
  return why;
}

Result<FrameWhy> explainByGuess(const Picture& golden, const Picture& frame,
                                const DrawableSide& frame_side) {
  const auto identity = frame_side.drawer.identity(frame_side.request);
  if (!identity.ok()) return identity.error();
  const auto views = frame_side.drawer.views(frame_side.request);
  if (!views.ok()) return views.error();
  FrameWhy why;
  why.blame = guessViews(golden, {frame, identity->frame}, *views, frame_side.drawer.cell());
  findCauses({}, {}, why);
  return why;
}

}  // namespace rocinante
