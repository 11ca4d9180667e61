#pragma once

#include "viewer/render/gl_table.h"

namespace rocinante {

/// Part of a picture, in pixels from its top left.
struct PixelRectangle {
  int x = 0, y = 0;
  int width = 0, height = 0;
  bool operator==(const PixelRectangle&) const = default;
};

/// From here on GL draws and clears in this part of a framebuffer of that height alone.
inline void setViewport(const GlTable& gl, const PixelRectangle& part, int frame_height) {
  const int bottom = frame_height - part.y - part.height;
  gl.Viewport(part.x, bottom, part.width, part.height);
  gl.Scissor(part.x, bottom, part.width, part.height);
  gl.Enable(GL_SCISSOR_TEST);
}

}  // namespace rocinante
