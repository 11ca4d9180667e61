#pragma once

#include <optional>

#include "viewer/render/renderer.h"
#include "viewer/ui/panels/panels.h"
#include "viewer/ui/program/frame_journal.h"

namespace rocinante {

/// Keeps what a window's frames cost and when the scene was drawn last, for its panels and for the
/// journal. Main thread.
class FrameTally {
 public:
  FrameTally() = default;
  explicit FrameTally(FrameJournal journal) : journal_(std::move(journal)) {}

  /// A frame was drawn in `times`; `counts`: with its scene, whose stages are parts of them.
  /// Returns the whole cost of one with a scene, in ms.
  std::optional<double> drawn(const std::optional<DrawCounts>& counts, FrameTimes times,
                              SteadyTime now, ViewerStatus& status);
  /// The scene was not drawn for a while.
  bool isStill(SteadyTime now) const;
  /// Writes down the frame that was just shown: what of it is not known here is set in `frame`.
  void writeDown(ShownFrame frame);
  bool isWritten() const { return journal_.active(); }

 private:
  FrameJournal journal_;
  FrameTimes times_;          ///< of the frame that last drew the scene
  bool scene_drawn_ = false;  ///< in the last frame
  SteadyTime scene_drawn_at_{};
};

}  // namespace rocinante
