#include "viewer/render/scaled_view.h"

#include <algorithm>

namespace rocinante {
namespace {

int scaledPixels(int pixels, double factor) { return static_cast<int>(pixels * factor + 0.5); }

PixelRectangle scaledPart(const PixelRectangle& part, double factor) {
  return {scaledPixels(part.x, factor), scaledPixels(part.y, factor),
          std::max(1, scaledPixels(part.width, factor)),
          std::max(1, scaledPixels(part.height, factor))};
}

}  // namespace

Status ScaledView::make(const GlTable& gl, int width, int height, int samples,
                        std::optional<FrameBuffer>& made) {
  if (made && made->width() == width && made->height() == height && made->samples() == samples &&
      !made->isOfContext()) {
    return {};
  }
  made.reset();
  auto fresh = FrameBuffer::create(gl, width, height, samples);
  if (!fresh.ok()) return fresh.error();
  made = std::move(*fresh);
  return {};
}

Status ScaledView::prepare(const GlTable& gl, int width, int height, int samples,
                           const DetailRung& rung) {
  rung_ = rung;
  const int wanted_samples = rung.multisampled ? samples : 1;
  if (rung.resolution >= 1) {
    scaled_.reset();
    return make(gl, width, height, wanted_samples, picture_);
  }
  if (gl.is_embedded) {
    // A page has no window around it: the picture is the canvas, and needs no copy.
    picture_ = FrameBuffer::ofContext(gl, width, height);
  } else if (auto ready = make(gl, width, height, 1, picture_); !ready) {
    return ready;
  }
  return make(gl, std::max(1, scaledPixels(width, rung.resolution)),
              std::max(1, scaledPixels(height, rung.resolution)), wanted_samples, scaled_);
}

Result<DrawCounts> ScaledView::draw(Renderer& renderer, SceneFrame frame) const {
  frame.detail = rung_.level;
  if (scaled_) return drawStretched(renderer, frame);
  frame.on_top = true;
  auto drawn = renderer.draw(frame, *picture_);
  if (drawn.ok()) picture_->resolve();
  return drawn;
}

Result<DrawCounts> ScaledView::drawStretched(Renderer& renderer, const SceneFrame& frame) const {
  std::vector<FrameInset> insets(frame.insets.begin(), frame.insets.end());
  for (FrameInset& inset : insets) inset.part = scaledPart(inset.part, rung_.resolution);
  SceneFrame scaled = frame;
  scaled.insets = insets;
  scaled.on_top = false;
  auto drawn = renderer.draw(scaled, *scaled_);
  if (!drawn.ok()) return drawn;
  scaled_->resolve();
  scaled_->stretchTo(*picture_);
  // Labels of the main view must not cover an inset: refill each inset before its own labels.
  const auto refill = [&](std::size_t inset) {
    scaled_->stretchPartTo(insets[inset].part, *picture_, frame.insets[inset].part);
  };
  if (auto crisp = renderer.drawOnTop(frame, *picture_, refill); !crisp) return crisp.error();
  return drawn;
}

}  // namespace rocinante
