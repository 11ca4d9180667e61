#include "viewer/passes/grid_pass.h"

#include <array>
#include <glm/gtc/type_ptr.hpp>
#include <string>
#include <utility>

#include "viewer/gl/depth_lift.h"
#include "viewer/passes/contact_shaders.h"
#include "viewer/passes/look_shaders.h"
#include "viewer/passes/shader_source.h"

namespace rocinante {

GridPass::GridPass(const GlTable& gl) : gl_(gl) {
  gl_.BindVertexArray(array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_);
  constexpr std::array<float, 8> kCorners{-1, -1, 1, -1, -1, 1, 1, 1};
  gl_.BufferData(GL_ARRAY_BUFFER, sizeof(kCorners), kCorners.data(), GL_STATIC_DRAW);
  gl_.EnableVertexAttribArray(0);
  gl_.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl_.BindVertexArray(0);
}

/// The one that is darkened by shadows, by contact, by both or by neither.
Result<const ShaderProgram*> GridPass::program(bool by_shadows, bool by_contact) {
  const auto found = programs_.find({by_shadows, by_contact});
  if (found != programs_.end()) return &found->second;
  std::string vertex(shader::kGridVertex), fragment(shader::kGridFragment);
  if (by_contact) {
    vertex = shader::withContact(vertex, false);
    fragment = shader::withContact(fragment, true);
  }
  if (by_shadows) {
    vertex = shader::withShadows(vertex, false);
    fragment = shader::withShadows(fragment, true);
  }
  auto made = ShaderProgram::link(gl_, "grid", vertex, fragment);
  if (!made) return made.error();
  return &programs_.emplace(std::pair(by_shadows, by_contact), std::move(*made)).first->second;
}

Status GridPass::draw(const Camera& camera, const CellScene& look, double scale,
                      const ShadowLookup* shadows, const ContactLookup* contact) {
  if (!(look.grid_size_m > 0) || !(look.grid_step_m > 0)) return {};
  // A light from below casts no shadow on the ground.
  const bool by_shadows = shadows != nullptr && look.light_direction.z > 0;
  const auto made = program(by_shadows, contact != nullptr);
  if (!made) return made.error();
  const ShaderProgram& program = **made;
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthMask(GL_FALSE);
  gl_.Enable(GL_BLEND);
  // Floors that lie on the ground hide it.
  gl_.Enable(GL_POLYGON_OFFSET_FILL);
  setDepthLift(gl_, -1);
  program.use();
  if (by_shadows) bindShadows(gl_, program, *shadows);
  if (contact != nullptr) {
    bindContact(gl_, program, *contact);
    const glm::vec3 forward(camera.forward());
    gl_.Uniform3f(program.uniform("view_direction"), forward.x, forward.y, forward.z);
  }
  const glm::mat4 clip(camera.clipFromRelative());
  gl_.UniformMatrix4fv(program.uniform("clip_from_relative"), 1, GL_FALSE, glm::value_ptr(clip));
  const glm::vec3 center(-camera.eye());
  gl_.Uniform3f(program.uniform("center_from_eye"), center.x, center.y, center.z);
  gl_.Uniform1f(program.uniform("half_size"), static_cast<float>(look.grid_size_m));
  gl_.Uniform1f(program.uniform("grid_step"), static_cast<float>(look.grid_step_m));
  gl_.Uniform1f(program.uniform("scale"), static_cast<float>(scale));
  gl_.BindVertexArray(array_);
  gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
  gl_.Disable(GL_BLEND);
  gl_.DepthMask(GL_TRUE);
  return {};
}

}  // namespace rocinante
