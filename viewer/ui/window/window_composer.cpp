#include "viewer/ui/window/window_composer.h"

#include <utility>

namespace rocinante {
namespace {

/// Copies what lies in `damaged` of the window; clears it where the interface is alone.
void copyPicture(const GlTable& gl, const WindowContent& content, const FrameBuffer& target,
                 const PixelRectangle& damaged) {
  const PixelRectangle part = content.part();
  const PixelRectangle seen = overlapOf(part, damaged);
  target.bind();
  gl.Disable(GL_SCISSOR_TEST);
  if (seen != damaged) {
    // Panels cover all of it, but for a pixel at their edges perhaps.
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(damaged.x, content.height - damaged.y - damaged.height, damaged.width,
               damaged.height);
    gl.ClearColor(0, 0, 0, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Disable(GL_SCISSOR_TEST);
  }
  if (seen.width <= 0 || seen.height <= 0) return;
  content.picture.copyPartTo({seen.x - part.x, seen.y - part.y, seen.width, seen.height}, target,
                             part.x, part.y);
  target.bind();
}

}  // namespace

Status WindowComposer::prepare(const GlTable& gl, int width, int height) {
  if (composed_ && composed_->width() == width && composed_->height() == height) return {};
  composed_.reset();
  auto made = FrameBuffer::create(gl, width, height, 1);
  if (!made.ok()) return made.error();
  composed_ = std::move(*made);
  damage_.forget();
  return {};
}

Status WindowComposer::composeAside(const GlTable& gl, const WindowContent& content,
                                    ImguiPainter& painter) {
  damage_.forget();
  if (auto ready = prepare(gl, content.width, content.height); !ready) return ready;
  copyPicture(gl, content, *composed_, {0, 0, content.width, content.height});
  painter.draw(content.interface, content.width, content.height);
  return {};
}

Result<bool> WindowComposer::compose(const GlTable& gl, const WindowContent& content,
                                     ImguiPainter& painter, bool same_picture) {
  const int width = content.width, height = content.height;
  const bool stays = part_ == content.part();
  part_ = content.part();
  if (!same_picture || !stays) {
    damage_.forget();
    copyPicture(gl, content, FrameBuffer::ofContext(gl, width, height), {0, 0, width, height});
    painter.draw(content.interface, width, height);
    return true;
  }
  if (auto ready = prepare(gl, width, height); !ready) return ready.error();
  const PixelRectangle part = damage_.since(content.interface, width, height);
  if (part.width <= 0 || part.height <= 0) return false;
  copyPicture(gl, content, *composed_, part);
  painter.draw(content.interface, width, height, part);
  composed_->blitTo(0);
  return true;
}

}  // namespace rocinante
