#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "viewer/gl/render_context.h"
#include "viewer/ui/window/input_queue.h"

struct GLFWwindow;

namespace rocinante {

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
  /// Whether the pointer is the window's to follow: over it, or the window has the keyboard.
  bool followsPointer() const;
  bool closeRequested() const;
  void requestClose();
  /// Shows what was drawn into framebuffer 0. Waits for the display when `paced`.
  void swap();
  void setPaced(bool paced);
  /// What mouse and keys did, for frames to take one by one: also keys let go again before anybody
  /// looked, which asking for a key's state in every frame would miss when a frame takes long.
  InputQueue& input() { return input_; }
  /// Whether a person did anything since the last call.
  bool takeNews() { return std::exchange(news_, false); }

 private:
  explicit Window(GLFWwindow* window);
  static Window& of(GLFWwindow* window);
  static void onKey(GLFWwindow* window, int key, int scancode, int action, int modifiers);
  static void onMove(GLFWwindow* window, double x, double y);
  static void onButton(GLFWwindow* window, int button, int action, int modifiers);
  static void onWheel(GLFWwindow* window, double across, double down);

  GLFWwindow* window_;
  InputQueue input_;
  double mouse_x_ = 0, mouse_y_ = 0;  // of the last event, in the window's own units
  bool news_ = false;
};

}  // namespace rocinante
