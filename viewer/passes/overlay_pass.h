#pragma once

#include "viewer/gl/gl_name.h"
#include "viewer/gl/shader_program.h"
#include "viewer/overlay/overlay.h"
#include "viewer/passes/overlay_buffer.h"

namespace rocinante {

/// Draws Overlay triangles, whose size is in pixels, into the bound framebuffer, between
/// DrawPasses::begin() and end(). Its context must be current whenever it is used or destroyed.
class OverlayPass {
 public:
  /// Begins its program.
  explicit OverlayPass(const GlTable& gl);

  /// Required before it draws; waits for the driver on first use.
  Status prepare();

  /// Sets the atlas of the following text.
  void useText(const TextAtlas& atlas);
  /// Draws depth-tested, in the scene.
  void drawInScene(const Overlay& overlay) const;
  /// Draws over everything.
  void drawOnTop(const Overlay& overlay) const;

 private:
  void drawVertices(const Overlay& overlay) const;

  const GlTable& gl_;
  ShaderProgram program_;
  bool ready_ = false;
  OverlayBuffer buffer_;
  GlTexture atlas_texture_{gl_};
  int line_px_ = 0;  ///< of the atlas in the texture
};

}  // namespace rocinante
