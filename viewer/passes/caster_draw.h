#pragma once

#include <span>

#include "viewer/gl/shader_program.h"
#include "viewer/passes/drawn_set.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// Items that are more opaque than not keep light from others. Blended pictures with holes do not;
/// those of AlphaMode::mask do where they are drawn.
bool keepsLight(const DrawItem& item);

/// Draws the depths of what keeps light away, for shadows and contact. Its context must be current
/// whenever it is used or destroyed.
class CasterDraw {
 public:
  static Result<CasterDraw> create(const GlTable& gl);
  /// Into the bound framebuffer, with the depth state that the caller has set.
  void draw(std::span<const DrawnSet> sets, const Camera& camera) const;

 private:
  CasterDraw(const GlTable& gl, ShaderProgram whole, ShaderProgram cut);
  void useCutout(const DrawItem& item, const TextureStore& textures) const;

  const GlTable* gl_;
  ShaderProgram whole_, cut_;
  GLint clip_from_model_, cut_clip_from_model_, map_along_, map_offset_, cutoff_;
};

}  // namespace rocinante
