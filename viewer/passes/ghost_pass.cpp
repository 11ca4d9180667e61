#include "viewer/passes/ghost_pass.h"

#include <glm/gtc/type_ptr.hpp>

#include "viewer/gl/depth_lift.h"
#include "viewer/passes/draw_triangles.h"
#include "viewer/passes/look_shaders.h"
#include "viewer/passes/shader_source.h"

namespace rocinante {
Result<GhostPass> GhostPass::create(const GlTable& gl) {
  auto program = ShaderProgram::link(gl, "ghost", shader::kSceneVertex, shader::kGhostFragment);
  if (!program) return program.error();
  return GhostPass(gl, std::move(*program));
}

GhostPass::GhostPass(const GlTable& gl, ShaderProgram program)
    : gl_(gl), program_(std::move(program)) {}

void GhostPass::draw(const std::vector<DrawItem>& items, const SceneCatalog& catalog,
                     const MeshBuffers& meshes, const Camera& camera) const {
  if (items.empty()) return;
  program_.use();
  const GLint clip = program_.uniform("clip_from_model");
  const GLint relative_place = program_.uniform("relative_from_model");
  const GLint normal = program_.uniform("normal_from_model");
  const GLint tone = program_.uniform("tone");
  const glm::vec3 forward(camera.forward());
  gl_.Uniform1i(program_.uniform("orthographic"), camera.orthographic() ? 1 : 0);
  gl_.Uniform3f(program_.uniform("view_direction"), forward.x, forward.y, forward.z);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.Enable(GL_BLEND);
  gl_.Enable(GL_POLYGON_OFFSET_FILL);
  setDepthLift(gl_, kBehindRanks);
  // All depths before the first colour, so that links do not show through each other.
  for (const bool colors : {false, true}) {
    const GLboolean mask = colors ? GL_TRUE : GL_FALSE;
    gl_.ColorMask(mask, mask, mask, GL_FALSE);
    for (const DrawItem& item : items) {
      const Mat4 relative = camera.relative(item.world);
      const glm::mat4 clip_from_model(camera.clipFromRelative() * relative);
      const glm::mat4 relative_from_model(relative);
      // Good enough for rims at any scale.
      const glm::mat3 normal_from_model(relative_from_model);
      gl_.UniformMatrix4fv(clip, 1, GL_FALSE, glm::value_ptr(clip_from_model));
      gl_.UniformMatrix4fv(relative_place, 1, GL_FALSE, glm::value_ptr(relative_from_model));
      gl_.UniformMatrix3fv(normal, 1, GL_FALSE, glm::value_ptr(normal_from_model));
      gl_.Uniform4f(tone, item.diffuse.r, item.diffuse.g, item.diffuse.b, item.diffuse.a);
      meshes.bind(item.mesh);
      drawTriangles(gl_, item, catalog);
    }
  }
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
  gl_.Disable(GL_BLEND);
}

}  // namespace rocinante
