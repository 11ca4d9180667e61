#include "viewer/passes/overlay_pass.h"

#include "viewer/passes/shader_source.h"

namespace rocinante {

OverlayPass::OverlayPass(const GlTable& gl)
    : gl_(gl),
      program_(
          ShaderProgram::begin(gl, "overlay", shader::kOverlayVertex, shader::kOverlayFragment)),
      buffer_(gl) {}

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
