#pragma once

#include "viewer/ui/window/window.h"

namespace rocinante {

/// Height of the interface's text at scale 1.
constexpr float kFontPixels = 15;

/// Dear ImGui's context, with the font whose bytes are fixed at build time. It counts in pixels of
/// the framebuffer, mouse included, also where a window's own units are larger. One at a time.
class InterfaceContext {
 public:
  /// `window` null: under a script, no mouse and no keyboard, sixty frames a second.
  explicit InterfaceContext(Window* window);
  ~InterfaceContext();
  InterfaceContext(const InterfaceContext&) = delete;
  InterfaceContext& operator=(const InterfaceContext&) = delete;

  /// Text and spacing for a screen of that scale, 1 to 4; true when they became others: the glyphs
  /// must then be uploaded anew. Between frames.
  bool useScale(float scale);
  float scale() const { return scale_; }
  void beginFrame(int width, int height);

 private:
  Window* window_;
  float scale_ = 0;
};

}  // namespace rocinante
