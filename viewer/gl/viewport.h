#pragma once

#include <optional>

#include "viewer/gl/gl_table.h"
#include "viewer/picture/pixel_rectangle.h"

namespace rocinante {

/// Places a view in this part of a framebuffer of that height, and restricts drawing and clearing
/// to it; with `only` to what lies in both.
inline void setViewport(const GlTable& gl, const PixelRectangle& part, int frame_height,
                        const std::optional<PixelRectangle>& only = {}) {
  gl.Viewport(part.x, frame_height - part.y - part.height, part.width, part.height);
  const PixelRectangle drawn = only ? overlapOf(part, *only) : part;
  gl.Scissor(drawn.x, frame_height - drawn.y - drawn.height, drawn.width, drawn.height);
  gl.Enable(GL_SCISSOR_TEST);
}

}  // namespace rocinante
