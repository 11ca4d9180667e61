#include "viewer/ui/scaled_view.h"

#include <algorithm>

namespace rocinante {

Status ScaledView::make(const GlTable& gl, int width, int height, int samples,
                        std::optional<FrameBuffer>& made) {
  if (made && made->width() == width && made->height() == height && made->samples() == samples) {
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
  const int wanted_samples = rung.multisampled ? samples : 1;
  if (rung.resolution >= 1) {
    scaled_.reset();
    return make(gl, width, height, wanted_samples, window_);
  }
  const auto scaled = [&](int pixels) {
    return std::max(1, static_cast<int>(pixels * rung.resolution + 0.5));
  };
  if (auto ready = make(gl, width, height, 1, window_); !ready) return ready;
  return make(gl, scaled(width), scaled(height), wanted_samples, scaled_);
}

void ScaledView::finishScene() const {
  scene().resolve();
  if (scaled_) {
    scaled_->stretchTo(*window_);
    window_->resolve();
  }
}

}  // namespace rocinante
