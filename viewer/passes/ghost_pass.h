#pragma once

#include "viewer/cull/draw_list.h"
#include "viewer/gl/shader_program.h"
#include "viewer/passes/mesh_buffers.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// Draws ghosts (GhostStyle::clear) into whatever framebuffer is bound: one tone, clear where it
/// faces the eye and denser at the rims, so that its shape is read without hiding what it stands
/// before. Of all ghosts only the nearest surface shows. They stand a hair behind where they are,
/// and so behind the actual device wherever both are in one place. Its context must be current
/// whenever it is used or destroyed.
class GhostPass {
 public:
  /// Behind by twice a surface's slope across a pixel, and what rounding of nearly equal poses
  /// makes (setDepthLift).
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
