#include "viewer/render/background_pass.h"

#include <utility>

#include "viewer/render/shader_source.h"

namespace rocinante {

Result<BackgroundPass> BackgroundPass::create(const GlTable& gl) {
  auto program =
      ShaderProgram::link(gl, "background", shader::kBackgroundVertex, shader::kBackgroundFragment);
  if (!program) return program.error();
  return BackgroundPass(gl, std::move(*program));
}

BackgroundPass::BackgroundPass(const GlTable& gl, ShaderProgram program)
    : gl_(gl), program_(std::move(program)) {
  gl_.GenVertexArrays(1, &empty_array_);
}

BackgroundPass::BackgroundPass(BackgroundPass&& other) noexcept
    : gl_(other.gl_),
      program_(std::move(other.program_)),
      empty_array_(std::exchange(other.empty_array_, 0)) {}

BackgroundPass::~BackgroundPass() { gl_.DeleteVertexArrays(1, &empty_array_); }

void BackgroundPass::draw(const CellScene& look) const {
  gl_.Disable(GL_DEPTH_TEST);
  program_.use();
  const glm::vec3& top = look.background_top;
  const glm::vec3& bottom = look.background_bottom;
  gl_.Uniform3f(program_.uniform("top"), top.x, top.y, top.z);
  gl_.Uniform3f(program_.uniform("bottom"), bottom.x, bottom.y, bottom.z);
  gl_.BindVertexArray(empty_array_);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace rocinante
