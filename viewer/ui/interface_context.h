#pragma once

struct GLFWwindow;

namespace rocinante {

/// Dear ImGui's context, with the font whose bytes are fixed at build time. One at a time.
class InterfaceContext {
 public:
  /// `window` null: under a script, no mouse and no keyboard, sixty frames a second.
  explicit InterfaceContext(GLFWwindow* window);
  ~InterfaceContext();
  InterfaceContext(const InterfaceContext&) = delete;
  InterfaceContext& operator=(const InterfaceContext&) = delete;

  void beginFrame(int width, int height);

 private:
  GLFWwindow* window_;
};

}  // namespace rocinante
