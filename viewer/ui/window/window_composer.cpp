#include "viewer/ui/window/window_composer.h"

#include <utility>

namespace rocinante {

Status WindowComposer::prepare(const GlTable& gl, int width, int height) {
  if (composed_ && composed_->width() == width && composed_->height() == height) return {};
  composed_.reset();
  auto made = FrameBuffer::create(gl, width, height, 1);
  if (!made.ok()) return made.error();
  composed_ = std::move(*made);
  damage_.forget();
  return {};
}

Status WindowComposer::composeAside(const GlTable& gl, const FrameBuffer& picture,
                                    ImguiPainter& painter, const ImDrawData& interface) {
  const int width = picture.width(), height = picture.height();
  damage_.forget();
  if (auto ready = prepare(gl, width, height); !ready) return ready;
  picture.copyPartTo({0, 0, width, height}, *composed_);
  painter.draw(interface, width, height);
  return {};
}

Result<bool> WindowComposer::compose(const GlTable& gl, const FrameBuffer& picture,
                                     ImguiPainter& painter, const ImDrawData& interface,
                                     bool same_picture) {
  const int width = picture.width(), height = picture.height();
  if (!same_picture) {
    damage_.forget();
    picture.blitTo(0);
    painter.draw(interface, width, height);
    return true;
  }
  if (auto ready = prepare(gl, width, height); !ready) return ready.error();
  const PixelRectangle part = damage_.since(interface, width, height);
  if (part.width <= 0 || part.height <= 0) return false;
  picture.copyPartTo(part, *composed_);
  painter.draw(interface, width, height, part);
  composed_->blitTo(0);
  return true;
}

}  // namespace rocinante
