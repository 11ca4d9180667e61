#pragma once

#include <optional>

#include "core/cell/cell.h"
#include "viewer/gl/shader_program.h"
#include "viewer/passes/shadow_map.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// Draws the ground grid into whatever framebuffer is bound, between DrawPasses::begin() and end().
/// Its context must be current whenever it is used or destroyed.
class GridPass {
 public:
  static Result<GridPass> create(const GlTable& gl);
  ~GridPass();
  GridPass(GridPass&& other) noexcept;
  GridPass& operator=(GridPass&&) = delete;

  /// Nothing when the cell's grid has no size or no step.
  /// With `shadows` they fall on the ground that it covers.
  Status draw(const Camera& camera, const CellScene& look, double scale,
              const ShadowLookup* shadows);

 private:
  GridPass(const GlTable& gl, ShaderProgram program);

  const GlTable& gl_;
  ShaderProgram program_;
  std::optional<ShaderProgram> with_shadows_;  // made when it is first asked for
  GLuint array_ = 0, vertices_ = 0;
};

}  // namespace rocinante
