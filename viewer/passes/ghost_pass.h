#pragma once

#include "viewer/cull/draw_list.h"
#include "viewer/gl/shader_program.h"
#include "viewer/passes/mesh_buffers.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// Draws ghosts (GhostStyle::clear) into the bound framebuffer: one tone, clear where it faces the
/// eye and denser at the rims, so that its shape is visible without hiding the scene. Only the
/// nearest surface of all ghosts shows. Ghosts are moved back slightly, behind the actual device
/// where both coincide. Its context must be current whenever it is used or destroyed.
class GhostPass {
 public:
  /// Twice a surface's slope across a pixel plus the rounding of nearly equal poses (setDepthLift).
  static constexpr float kBehindRanks = -20;

  static Result<GhostPass> create(const GlTable& gl);

  void draw(const std::vector<DrawItem>& items, const SceneCatalog& catalog,
            const MeshBuffers& meshes, const Camera& camera) const;

 private:
  GhostPass(const GlTable& gl, ShaderProgram program);

  const GlTable& gl_;
  ShaderProgram program_;
};

}  // namespace rocinante
