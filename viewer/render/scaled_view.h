#pragma once

#include <optional>

#include "viewer/detail/detail_level.h"
#include "viewer/gl/frame_buffer.h"
#include "viewer/render/renderer.h"

namespace rocinante {

/// Draws frames on a rung of detail: the scene at the rung's resolution and with its samples, then
/// stretched to the picture's resolution, where labels, gnomon and the frames of insets are drawn
/// sharply. On rung 0 both are one framebuffer. Its context must be current whenever it is used or
/// destroyed.
///
///   view.prepare(gl, width, height, samples, rung);
///   view.draw(renderer, frame);  // the picture's pixels are bound now: draw an interface here
///   view.picture().blitTo(0);    // or read()
class ScaledView {
 public:
  /// Creates missing framebuffers and releases unneeded ones.
  Status prepare(const GlTable& gl, int width, int height, int samples, const DetailRung& rung);

  /// `frame` is in pixels of the picture; its detail and on_top are set by the prepared rung.
  Result<DrawCounts> draw(Renderer& renderer, SceneFrame frame) const;

  /// The picture, one sample per pixel, of the requested size.
  const FrameBuffer& picture() const { return *picture_; }

 private:
  static Status make(const GlTable& gl, int width, int height, int samples,
                     std::optional<FrameBuffer>& made);
  Result<DrawCounts> drawStretched(Renderer& renderer, const SceneFrame& frame) const;

  DetailRung rung_;
  std::optional<FrameBuffer> picture_;
  std::optional<FrameBuffer> scaled_;  ///< only below full resolution
};

}  // namespace rocinante
