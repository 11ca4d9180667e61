#pragma once

#include "viewer/gl/shader_program.h"
#include "viewer/overlay/overlay.h"
#include "viewer/passes/overlay_buffer.h"

namespace rocinante {

/// Draws what has its size in pixels (Overlay) into whatever framebuffer is bound, between
/// DrawPasses::begin() and end(). Its context must be current whenever it is used or destroyed.
class OverlayPass {
 public:
  static Result<OverlayPass> create(const GlTable& gl, const TextAtlas& atlas);
  ~OverlayPass();
  OverlayPass(OverlayPass&& other) noexcept;
  OverlayPass& operator=(OverlayPass&&) = delete;

  /// Text from here on is of this atlas.
  void useText(const TextAtlas& atlas);
  /// Depth-tested, in the scene.
  void drawInScene(const Overlay& overlay) const;
  /// Over everything.
  void drawOnTop(const Overlay& overlay) const;

 private:
  OverlayPass(const GlTable& gl, ShaderProgram program, const TextAtlas& atlas);
  void drawVertices(const Overlay& overlay) const;

  const GlTable& gl_;
  ShaderProgram program_;
  OverlayBuffer buffer_;
  GLuint atlas_texture_ = 0;
  int line_px_ = 0;  ///< of the atlas in the texture
};

}  // namespace rocinante
