#include "viewer/passes/draw_passes.h"

#include <utility>

#include "viewer/gl/viewport.h"

namespace rocinante {

Status DrawPasses::prepare(const SurfaceLook& surfaces, const CellScene& look) {
  if (Status ready = background.prepare(); !ready) return ready;
  if (Status ready = overlay.prepare(); !ready) return ready;
  return scene.prepare(surfaces, look);
}

void DrawPasses::begin(const CellScene& look, const PixelRectangle& part, int frame_height,
                       const std::optional<PixelRectangle>& only) {
  background.draw(look, part, frame_height, only);
  gl.DepthMask(GL_TRUE);
  gl.ClearDepth(0);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  beginOnTop(part, frame_height, only);
}

void DrawPasses::beginOnTop(const PixelRectangle& part, int frame_height,
                            const std::optional<PixelRectangle>& only) const {
  if (gl.ClipControl != nullptr) gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  setViewport(gl, part, frame_height, only);
  gl.Disable(GL_CULL_FACE);
  gl.Disable(GL_BLEND);
  gl.Disable(GL_POLYGON_OFFSET_FILL);
  gl.ActiveTexture(GL_TEXTURE0);
  // A frame stays opaque under blending.
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  // Later draws win at equal depths: the drawing order is fixed.
  gl.DepthFunc(GL_GEQUAL);
}

void DrawPasses::end() const {
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.Disable(GL_SCISSOR_TEST);
  gl.Disable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);
  gl.ClearDepth(1);
  gl.BindVertexArray(0);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  gl.UseProgram(0);
  if (gl.ClipControl != nullptr) gl.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
}

}  // namespace rocinante
