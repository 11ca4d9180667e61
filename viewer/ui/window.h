#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"
#include "viewer/render/render_context.h"

struct GLFWwindow;

namespace rocinante {

/// A key that went down, or that repeats while it is held.
struct KeyPress {
  int key = 0;  ///< GLFW's number
  bool shift = false;
  bool repeated = false;
};

/// A window with a GL 3.3 core context, by GLFW. Main thread only. One at a time.
class Window final : public RenderContext {
 public:
  /// refused with GLFW's own words when there is no display or no such context.
  /// `scaled`: the size is meant for a screen of scale 1, and grows with this screen's.
  static Result<std::unique_ptr<Window>> open(const std::string& title, int width, int height,
                                              bool scaled);

  ~Window() override;

  Status makeCurrent() override;
  GlProc procAddress(const char* name) const override;
  std::string_view name() const override { return "GLFW"; }

  GLFWwindow* handle() const { return window_; }
  /// Pixels of the framebuffer, which may be more than the window's own units.
  int framebufferWidth() const;
  int framebufferHeight() const;
  /// How much larger than usual the screen's text should be: 2 where pixels are half as large.
  float contentScale() const;
  bool closeRequested() const;
  void requestClose();
  /// Shows what was drawn into framebuffer 0. Waits for the display when `paced`.
  void swap();
  void setPaced(bool paced);
  /// The keys pressed since the last call, in order: also those let go again before anybody looked,
  /// which asking for a key's state in every frame would miss when a frame takes long.
  std::vector<KeyPress> takeKeyPresses() { return std::exchange(key_presses_, {}); }

 private:
  explicit Window(GLFWwindow* window);
  static void onKey(GLFWwindow* window, int key, int scancode, int action, int modifiers);

  GLFWwindow* window_;
  std::vector<KeyPress> key_presses_;
};

}  // namespace rocinante
