#pragma once

#include <optional>
#include <vector>

#include "viewer/ui/window/frame_input.h"
#include "viewer/ui/window/window.h"

namespace rocinante {

/// Height of the interface's text at scale 1.
constexpr float kFontPixels = 15;
/// From one frame of a script to the next.
constexpr float kScriptedSeconds = 1.0F / 60.0F;

/// Dear ImGui's context, with the embedded font. Uses framebuffer pixels, also for the mouse, even
/// when window units are larger. One at a time.
class InterfaceContext {
 public:
  /// `window` null: under a script, which says what its frames see of mouse and keyboard.
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
  /// `scripted`: what the frame sees, without a window; null: nothing new. `seconds`: since the
  /// last frame; empty: as the clock has it, or sixty frames a second under a script. `taker`: who
  /// takes the keys of a window.
  void beginFrame(int width, int height, const FrameInput* scripted = nullptr,
                  std::optional<float> seconds = {}, KeyTaker taker = KeyTaker::commands);
  /// Keys of this frame.
  const std::vector<KeyPress>& presses() const { return presses_; }
  /// What this frame sees.
  FrameInput seen() const;

 private:
  void restyle();
  void tellKeys(const std::vector<KeyPress>& presses);
  void tellWindow(double width, double height, KeyTaker taker);

  Window* window_;
  std::vector<int> reported_keys_;  ///< of the last frame
  std::vector<KeyPress> presses_;   ///< of this frame
  float scale_ = 0;
  bool light_ = false;
};

}  // namespace rocinante
