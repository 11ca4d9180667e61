#include "viewer/ui/program/moment_preview.h"

#include <algorithm>
#include <chrono>

#include "viewer/view/camera_choice.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace rocinante {
namespace {

constexpr double kWidthPx = 208;
/// So long the mouse rests first: a picture costs more than a frame of panels.
constexpr Nanoseconds kRest = std::chrono::milliseconds(60);

}  // namespace

bool MomentPreview::advance(Renderer& renderer, int width, int height, double scale,
                            SteadyTime now) {
  const std::optional<LogTime> wanted = model_.viewer.hover.wanted;
  if (wanted != wanted_) {
    wanted_ = wanted;
    wanted_since_ = now;
  }
  if (!wanted || model_.session() == nullptr || wanted == done_) return false;
  if (wanted != asked_) {
    if (now - wanted_since_ < kRest) return false;
    if (!study_) study_.emplace(model_.cell(), [] { glfwPostEmptyEvent(); });
    if (study_->busy()) return false;
    study_->ask(model_.session()->logAt(*wanted).name(), *wanted);
    asked_ = wanted;
    return false;
  }
  if (!study_ || study_->busy()) return false;
  done_ = wanted;
  const PosedScene* const scene = study_->scene();
  width_ = static_cast<int>(kWidthPx * scale);
  height_ = std::clamp(width_ * height / std::max(width, 1), width_ / 3, width_);
  if (scene == nullptr || !draw(renderer, *scene)) return false;
  model_.viewer.hover.drawn = wanted;
  return true;
}

bool MomentPreview::draw(Renderer& renderer, const PosedScene& scene) {
  const GlTable& gl = renderer.gl();
  if (!pixels_ || pixels_->width() != width_ || pixels_->height() != height_) {
    pixels_.reset();
    auto made = FrameBuffer::create(gl, width_, height_, 1);
    if (!made.ok()) return false;
    pixels_ = std::move(*made);
  }
  RenderStyle style = model_.style();
  style.shadows = style.contact = false;
  const auto named = chooseCamera(model_.cameraName(), scene);
  SceneFrame frame;
  frame.scene = &scene;
  frame.camera = named.ok() ? *named : model_.cameraView();
  frame.choice = &model_.choice();
  frame.style = &style;
  frame.on_top = false;
  if (!renderer.draw(frame, *pixels_).ok()) return false;
  pixels_->resolve();
  const Picture picture = pixels_->read();
  if (texture_ == 0) texture_ = GlTexture(gl);
  model_.viewer.hover.texture = texture_;
  gl.BindTexture(GL_TEXTURE_2D, texture_);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_, height_, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                picture.rgba.data());
  gl.BindTexture(GL_TEXTURE_2D, 0);
  model_.viewer.hover.width = width_;
  model_.viewer.hover.height = height_;
  return true;
}

}  // namespace rocinante
