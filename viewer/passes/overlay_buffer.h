#pragma once

#include <span>

#include "viewer/gl/gl_name.h"
#include "viewer/overlay/overlay.h"

namespace rocinante {

/// Triangles of an overlay on the GPU, as attributes 0 to 3: clip (vec4), texture (vec2), colour
/// (vec4) and kind (uint). Its context must be current whenever it is used or destroyed.
class OverlayBuffer {
 public:
  explicit OverlayBuffer(const GlTable& gl);

  /// Uploads the vertices and draws them with the program in use.
  void draw(std::span<const OverlayVertex> vertices) const;

 private:
  const GlTable& gl_;
  GlVertexArray array_{gl_};
  GlBuffer vertices_{gl_};
};

}  // namespace rocinante
