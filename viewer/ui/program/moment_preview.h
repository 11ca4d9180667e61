#pragma once

#include <optional>

#include "viewer/gl/gl_name.h"
#include "viewer/render/renderer.h"
#include "viewer/render/scaled_view.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/study/moment_study.h"

namespace rocinante {

/// Draws the small picture of the moment at which the mouse rests on the time line, when the window
/// has nothing else to do. Main thread; its context must be current. Borrows the model.
class MomentPreview {
 public:
  explicit MomentPreview(ViewModel& model) : model_(model) {}
  ~MomentPreview() { model_.viewer.hover = {}; }
  MomentPreview(const MomentPreview&) = delete;
  MomentPreview& operator=(const MomentPreview&) = delete;

  /// Continues with the picture, in a window of that size; true when there is a new one. What
  /// cannot be drawn has none.
  bool advance(Renderer& renderer, int width, int height, double scale, SteadyTime now);
  /// Waits for what advance() waits for.
  void wait() const {
    if (study_) study_->wait();
  }
  /// Ends the thread that reads the cell, until the next picture.
  void pause() { study_.reset(); }

 private:
  bool draw(Renderer& renderer, const PosedScene& scene);

  ViewModel& model_;
  std::optional<MomentStudy> study_;
  std::optional<LogTime> wanted_, asked_, done_;
  SteadyTime wanted_since_{};
  int width_ = 0, height_ = 0;
  std::optional<FrameBuffer> pixels_;
  GlTexture texture_;
};

}  // namespace rocinante
