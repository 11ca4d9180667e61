#pragma once

#include <optional>

#include "viewer/detail/detail_level.h"
#include "viewer/render/frame_buffer.h"

namespace rocinante {

/// Where the window's frame is drawn: the 3D view at the resolution and with the samples of a rung
/// of detail, and the window's own pixels over it for a crisp interface. On rung 0 both are one
/// framebuffer. Bound to the context of the table that it was made with.
///
///   view.prepare(gl, width, height, samples, rung);
///   renderer.draw(frame, view.scene());
///   view.finishScene();        // the window's pixels are bound now: draw the interface
///   view.window().blitTo(0);   // or read()
class ScaledView {
 public:
  /// Makes what is needed and is not there yet; gives away what is not needed any more.
  Status prepare(const GlTable& gl, int width, int height, int samples, const DetailRung& rung);

  const FrameBuffer& scene() const { return scaled_ ? *scaled_ : *window_; }
  const FrameBuffer& window() const { return *window_; }
  /// Resolves the samples and fills the window's pixels with the scene.
  void finishScene() const;

 private:
  static Status make(const GlTable& gl, int width, int height, int samples,
                     std::optional<FrameBuffer>& made);

  std::optional<FrameBuffer> window_;
  std::optional<FrameBuffer> scaled_;  ///< only below full resolution
};

}  // namespace rocinante
