#pragma once

#include "viewer/gl/shader_program.h"
#include "viewer/overlay/overlay.h"
#include "viewer/passes/overlay_buffer.h"

namespace rocinante {

/// Draws Overlay triangles, whose size is in pixels, into the bound framebuffer, between
/// DrawPasses::begin() and end(). Its context must be current whenever it is used or destroyed.
class OverlayPass {
 public:
  static Result<OverlayPass> create(const GlTable& gl, const TextAtlas& atlas);
  ~OverlayPass();
  OverlayPass(OverlayPass&& other) noexcept;
  OverlayPass& operator=(OverlayPass&&) = delete;

  /// Sets the atlas of the following text.
  void useText(const TextAtlas& atlas);
  /// Draws depth-tested, in the scene.
  void drawInScene(const Overlay& overlay) const;
  /// Draws over everything.
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
