#include "viewer/render/overlay_pass.h"

#include <cstddef>
#include <utility>

#include "viewer/render/shader_source.h"

namespace rocinante {

Result<OverlayPass> OverlayPass::create(const GlTable& gl, const TextAtlas& atlas) {
  auto program =
      ShaderProgram::link(gl, "overlay", shader::kOverlayVertex, shader::kOverlayFragment);
  if (!program) return program.error();
  return OverlayPass(gl, std::move(*program), atlas);
}

OverlayPass::OverlayPass(const GlTable& gl, ShaderProgram program, const TextAtlas& atlas)
    : gl_(gl), program_(std::move(program)) {
  gl_.GenVertexArrays(1, &array_);
  gl_.BindVertexArray(array_);
  gl_.GenBuffers(1, &vertices_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_);
  for (GLuint place = 0; place < 4; ++place) gl_.EnableVertexAttribArray(place);
  const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
  constexpr GLsizei kStride = sizeof(OverlayVertex);
  gl_.VertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(OverlayVertex, clip)));
  gl_.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, kStride,
                          offset(offsetof(OverlayVertex, texture)));
  gl_.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride,
                          offset(offsetof(OverlayVertex, abgr)));
  gl_.VertexAttribIPointer(3, 1, GL_UNSIGNED_INT, kStride, offset(offsetof(OverlayVertex, kind)));
  gl_.BindVertexArray(0);

  gl_.GenTextures(1, &atlas_texture_);
  gl_.BindTexture(GL_TEXTURE_2D, atlas_texture_);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, atlas.width(), atlas.height(), 0, GL_RED,
                 GL_UNSIGNED_BYTE, atlas.coverage().data());
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

OverlayPass::OverlayPass(OverlayPass&& other) noexcept
    : gl_(other.gl_),
      program_(std::move(other.program_)),
      array_(std::exchange(other.array_, 0)),
      vertices_(std::exchange(other.vertices_, 0)),
      atlas_texture_(std::exchange(other.atlas_texture_, 0)) {}

OverlayPass::~OverlayPass() {
  gl_.DeleteVertexArrays(1, &array_);
  gl_.DeleteBuffers(1, &vertices_);
  gl_.DeleteTextures(1, &atlas_texture_);
}

void OverlayPass::drawVertices(const Overlay& overlay) const {
  const auto& vertices = overlay.vertices();
  program_.use();
  gl_.BindTexture(GL_TEXTURE_2D, atlas_texture_);
  gl_.BindVertexArray(array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_);
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(OverlayVertex)),
                 vertices.data(), GL_STREAM_DRAW);
  gl_.Enable(GL_BLEND);
  gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
  gl_.Disable(GL_BLEND);
}

void OverlayPass::drawInScene(const Overlay& overlay) const {
  if (overlay.vertices().empty()) return;
  gl_.Enable(GL_DEPTH_TEST);
  drawVertices(overlay);
}

void OverlayPass::drawOnTop(const Overlay& overlay) const {
  if (overlay.vertices().empty()) return;
  gl_.Disable(GL_DEPTH_TEST);
  drawVertices(overlay);
}

}  // namespace rocinante
