#include "viewer/passes/overlay_pass.h"

#include <utility>

#include "viewer/passes/shader_source.h"

namespace rocinante {

OverlayPass::OverlayPass(const GlTable& gl)
    : gl_(gl),
      program_(
          ShaderProgram::begin(gl, "overlay", shader::kOverlayVertex, shader::kOverlayFragment)),
      buffer_(gl) {
  gl_.GenTextures(1, &atlas_texture_);
}

void OverlayPass::useText(const TextAtlas& atlas) {
  if (atlas.linePixels() == line_px_) return;
  line_px_ = atlas.linePixels();
  gl_.BindTexture(GL_TEXTURE_2D, atlas_texture_);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, atlas.width(), atlas.height(), 0, GL_RED,
                 GL_UNSIGNED_BYTE, atlas.coverage().data());
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

Status OverlayPass::prepare() {
  if (ready_) return {};
  Status linked = program_.finish();
  ready_ = linked.has_value();
  return linked;
}

OverlayPass::OverlayPass(OverlayPass&& other) noexcept
    : gl_(other.gl_),
      program_(std::move(other.program_)),
      ready_(other.ready_),
      buffer_(std::move(other.buffer_)),
      atlas_texture_(std::exchange(other.atlas_texture_, 0)),
      line_px_(other.line_px_) {}

OverlayPass::~OverlayPass() { gl_.DeleteTextures(1, &atlas_texture_); }

void OverlayPass::drawVertices(const Overlay& overlay) const {
  program_.use();
  gl_.BindTexture(GL_TEXTURE_2D, atlas_texture_);
  gl_.Enable(GL_BLEND);
  buffer_.draw(overlay.vertices());
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
