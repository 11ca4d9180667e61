#pragma once

#include <optional>

#include "viewer/gl/frame_buffer.h"
#include "viewer/ui/window/imgui_painter.h"
#include "viewer/ui/window/interface_damage.h"

namespace rocinante {

/// What a window shows, as far as it is drawn by others: the picture, in a part of it, and the
/// interface round and over that.
struct WindowContent {
  const FrameBuffer& picture;
  int x = 0, y = 0;           ///< of the picture, from the window's upper left corner
  int width = 0, height = 0;  ///< of the window
  const ImDrawData& interface;

  PixelRectangle part() const { return {x, y, picture.width(), picture.height()}; }
};

/// Puts the window's picture and the interface over it together. While the picture stays, only what
/// the interface changes is drawn. Its context must be current whenever it is used or destroyed.
class WindowComposer {
 public:
  /// Draws into the window. `same_picture`: `picture` is as in the last call. False: the window
  /// shows this already, and nothing was drawn.
  Result<bool> compose(const GlTable& gl, const WindowContent& content, ImguiPainter& painter,
                       bool same_picture);
  /// The same beside the window: whole, into composed().
  Status composeAside(const GlTable& gl, const WindowContent& content, ImguiPainter& painter);
  /// What was composed aside.
  const FrameBuffer& composed() const { return *composed_; }
  /// The window or a texture of the interface may have changed.
  void forget() { damage_.forget(); }

 private:
  Status prepare(const GlTable& gl, int width, int height);

  std::optional<FrameBuffer> composed_;  ///< what the window shows, while the picture stays
  std::optional<PixelRectangle> part_;   ///< where the picture was
  InterfaceDamage damage_;
};

}  // namespace rocinante
