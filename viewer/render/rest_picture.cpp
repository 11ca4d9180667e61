#include "viewer/render/rest_picture.h"

#include <utility>

namespace rocinante {

Status RestPicture::drawRows(Renderer& renderer, SceneFrame frame, int width, int height,
                             int samples, int drawn, int rows) {
  const bool fits = picture_ && picture_->width() == width && picture_->height() == height &&
                    picture_->samples() == samples;
  if (!fits) {
    picture_.reset();
    auto made = FrameBuffer::create(renderer.gl(), width, height, samples);
    if (!made.ok()) return made.error();
    picture_ = std::move(*made);
  }
  frame.detail = {};
  frame.on_top = true;
  frame.only = PixelRectangle{0, drawn, width, rows};
  frame.goes_on = drawn > 0 && renderer.framesDrawn() == frames_drawn_;
  if (const auto done = renderer.draw(frame, *picture_); !done) return done.error();
  frames_drawn_ = renderer.framesDrawn();
  if (drawn + rows >= height) picture_->resolve();
  return {};
}

}  // namespace rocinante
