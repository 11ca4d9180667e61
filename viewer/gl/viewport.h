#pragma once

#include "viewer/gl/gl_table.h"
#include "viewer/picture/pixel_rectangle.h"

namespace rocinante {

/// Restricts drawing and clearing to this part of a framebuffer of that height.
inline void setViewport(const GlTable& gl, const PixelRectangle& part, int frame_height) {
  const int bottom = frame_height - part.y - part.height;
  gl.Viewport(part.x, bottom, part.width, part.height);
  gl.Scissor(part.x, bottom, part.width, part.height);
  gl.Enable(GL_SCISSOR_TEST);
}

}  // namespace rocinante
