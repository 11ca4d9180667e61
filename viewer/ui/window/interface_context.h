#pragma once

#include <vector>

#include "viewer/ui/window/window.h"

namespace rocinante {

/// Height of the interface's text at scale 1.
constexpr float kFontPixels = 15;

/// Dear ImGui's context, with the embedded font. Uses framebuffer pixels, also for the mouse, even
/// when window units are larger. One at a time.
class InterfaceContext {
 public:
  /// `window` null: under a script, no mouse and no keyboard, sixty frames a second.
  explicit InterfaceContext(Window* window);
  ~InterfaceContext();
  InterfaceContext(const InterfaceContext&) = delete;
  InterfaceContext& operator=(const InterfaceContext&) = delete;

  /// Sets text and spacing for a screen scale of 1 to 4; true when they changed: the glyphs must
  /// then be uploaded again. Call between frames.
  bool useScale(float scale);
  /// Light or dark panels, with text in a color to match. Call between frames.
  void useTheme(bool light);
  float scale() const { return scale_; }
  void beginFrame(int width, int height);

 private:
  void restyle();
  void tellKeys(const std::vector<KeyPress>& presses);

  Window* window_;
  std::vector<int> told_keys_;  ///< of the last frame
  float scale_ = 0;
  bool light_ = false;
};

}  // namespace rocinante
