#include "viewer/passes/background_pass.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "viewer/gl/viewport.h"
#include "viewer/passes/shader_source.h"

namespace rocinante {

BackgroundPass::BackgroundPass(const GlTable& gl)
    : gl_(gl),
      program_(ShaderProgram::begin(gl, "background", shader::kBackgroundVertex,
                                    shader::kBackgroundFragment)) {}

Status BackgroundPass::prepare() {
  if (ready_) return {};
  Status linked = program_.finish();
  ready_ = linked.has_value();
  return linked;
}

void BackgroundPass::drawGradient(const CellScene& look) const {
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Disable(GL_BLEND);
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  program_.use();
  const glm::vec3& top = look.background_top;
  const glm::vec3& bottom = look.background_bottom;
  gl_.Uniform3f(program_.uniform("top"), top.x, top.y, top.z);
  gl_.Uniform3f(program_.uniform("bottom"), bottom.x, bottom.y, bottom.z);
  gl_.BindVertexArray(empty_array_);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

const BackgroundPass::Kept* BackgroundPass::kept(const CellScene& look, int width, int height,
                                                 GLint samples, GLuint bound) {
  const auto bytes = std::int64_t{4} * width * height * std::max(samples, 1);
  if (bytes > kKeptBytes) return nullptr;
  // Refuses to copy into samples; and there drawing costs no more than copying.
  if (gl_.is_embedded) return nullptr;
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) {
    return kept.width == width && kept.height == height && kept.samples == samples &&
           kept.top == look.background_top && kept.bottom == look.background_bottom;
  });
  if (found != kept_.end()) return &*found;

  Kept made{look.background_top, look.background_bottom, width, height, samples,
            GlFramebuffer(gl_),  GlRenderbuffer(gl_)};
  gl_.BindRenderbuffer(GL_RENDERBUFFER, made.color);
  gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, width, height);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, made.frame);
  gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, made.color);
  const bool complete = gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  if (complete) {
    setViewport(gl_, {0, 0, width, height}, height);
    drawGradient(look);
  }
  gl_.BindFramebuffer(GL_FRAMEBUFFER, bound);
  if (!complete) return nullptr;
  if (kept_.size() == kKept) kept_.erase(kept_.begin());
  kept_.push_back(std::move(made));
  return &kept_.back();
}

void BackgroundPass::draw(const CellScene& look, const PixelRectangle& part, int frame_height,
                          const std::optional<PixelRectangle>& only) {
  GLint bound = 0;
  GLint samples = 0;
  gl_.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  gl_.GetIntegerv(GL_SAMPLES, &samples);
  const Kept* const picture =
      kept(look, part.width, part.height, samples, static_cast<GLuint>(bound));
  setViewport(gl_, part, frame_height, only);
  if (picture == nullptr) {
    drawGradient(look);
    return;
  }
  const PixelRectangle drawn = only ? overlapOf(part, *only) : part;
  const int bottom = frame_height - drawn.y - drawn.height;
  const int from_x = drawn.x - part.x;
  const int from_y = part.y + part.height - drawn.y - drawn.height;
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, picture->frame);
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.BlitFramebuffer(from_x, from_y, from_x + drawn.width, from_y + drawn.height, drawn.x, bottom,
                      drawn.x + drawn.width, bottom + drawn.height, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(bound));
}

}  // namespace rocinante
