#pragma once

#include <filesystem>
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
  /// refused with GLFW's message when there is no display or no such context. `scaled`: the size is
  /// for scale 1 and is multiplied with the screen's scale.
  static Result<std::unique_ptr<Window>> open(const std::string& title, int width, int height,
                                              bool scaled);

  ~Window() override;

  Status makeCurrent() override;
  GlProc procAddress(const char* name) const override;
  std::string_view name() const override { return "GLFW"; }

  GLFWwindow* handle() const { return window_; }
  /// Pixels of the framebuffer, which may exceed the window's units.
  int framebufferWidth() const;
  int framebufferHeight() const;
  /// In the units of open(): without the screen's scale where it was asked for.
  std::pair<int, int> size() const;
  /// The screen's scale: 2 when pixels are half as large as usual.
  float contentScale() const;
  /// Whether the window follows the pointer: it is over the window, or the window has the focus.
  bool followsPointer() const;
  /// In pixels.
  void resize(int width, int height);
  /// It is gone for the user, while the program still ends what it does.
  void hide();
  void setTitle(const std::string& title);
  /// Files that were dropped on the window since the last call.
  std::vector<std::filesystem::path> takeDropped() { return std::exchange(dropped_, {}); }
  bool closeRequested() const;
  void requestClose();
  /// Shows framebuffer 0. Waits for the display when `paced`.
  void swap();
  void setPaced(bool paced);
  /// Takes the events that came, waiting for one for at most `most_s` seconds; 0: does not wait.
  void takeEvents(double most_s);
  /// From now on letters are events, and Dear ImGui's own callback does not hear of them.
  void takeLetters();
  /// Mouse and key events for frames to take one by one. Includes keys released before a frame,
  /// which polling would miss when a frame takes long.
  InputQueue& input() { return input_; }
  /// Whether there was any user input since the last call, or the window must be drawn again.
  bool takeNews() { return std::exchange(news_, false); }

 private:
  explicit Window(GLFWwindow* window);
  static Window& of(GLFWwindow* window);
  static void onKey(GLFWwindow* window, int key, int scancode, int action, int modifiers);
  static void onMove(GLFWwindow* window, double x, double y);
  static void onButton(GLFWwindow* window, int button, int action, int modifiers);
  static void onWheel(GLFWwindow* window, double across, double down);
  /// Of the window itself: its size, focus, or pixels that the system wants again.
  static void onNews(GLFWwindow* window);

  static void onDrop(GLFWwindow* window, int count, const char** paths);

  GLFWwindow* window_;
  bool scaled_ = false;
  std::vector<std::filesystem::path> dropped_;
  InputQueue input_;
  double mouse_x_ = 0, mouse_y_ = 0;  // of the last event, in window units
  bool news_ = false;
  SteadyTime asked_at_{}, answered_at_{};  // of the last takeEvents()
};

}  // namespace rocinante
