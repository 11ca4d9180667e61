#pragma once

#include <memory>
#include <string>

#include "core/result.h"
#include "viewer/render/render_context.h"

struct GLFWwindow;

namespace rocinante {

/// A window with a GL 3.3 core context, by GLFW. Main thread only. One at a time.
class Window final : public RenderContext {
 public:
  /// refused with GLFW's own words when there is no display or no such context.
  static Result<std::unique_ptr<Window>> open(const std::string& title, int width, int height);

  ~Window() override;

  Status makeCurrent() override;
  GlProc procAddress(const char* name) const override;
  std::string_view name() const override { return "GLFW"; }

  GLFWwindow* handle() const { return window_; }
  /// Pixels of the framebuffer, which may be more than the window's own units.
  int framebufferWidth() const;
  int framebufferHeight() const;
  bool closeRequested() const;
  void requestClose();
  /// Shows what was drawn into framebuffer 0. Waits for the display when `paced`.
  void swap();
  void setPaced(bool paced);

 private:
  explicit Window(GLFWwindow* window) : window_(window) {}

  GLFWwindow* window_;
};

}  // namespace rocinante
