#include "viewer/ui/window/window.h"

#include <dlfcn.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace rocinante {
namespace {

std::string last_glfw_error;

void onGlfwError(int /*code*/, const char* text) { last_glfw_error = text; }

/// Xlib ends the program when its server is gone, whatever this returns.
int onServerGone(void* /*display*/) {
  constexpr char kWhat[] = "rocinante-view: the connection to the display is lost\n";
  (void)!::write(STDERR_FILENO, kWhat, std::strlen(kWhat));
  ::_exit(2);
}

/// Replaces Xlib's handler, whose exit code 1 has another meaning here. GLFW has loaded Xlib if it
/// is installed.
void nameLossOfServer() {
  void* const xlib = ::dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD);
  if (xlib == nullptr) return;
  using Handler = int (*)(void*);
  using SetHandler = Handler (*)(Handler);
  if (auto* const set = reinterpret_cast<SetHandler>(::dlsym(xlib, "XSetIOErrorHandler"))) {
    set(onServerGone);
  }
  ::dlclose(xlib);
}

Error windowError(const std::string& what) {
  return {ErrorKind::refused,
          what + (last_glfw_error.empty() ? std::string() : ": " + last_glfw_error) +
              " (rocinante render draws without a display)",
          ""};
}

}  // namespace

Result<std::unique_ptr<Window>> Window::open(const std::string& title, int width, int height,
                                             bool scaled) {
  glfwSetErrorCallback(onGlfwError);
#ifdef GLFW_PLATFORM
  // GLFW 3.4 and later try Wayland first, whose library prints an error when only an X server is
  // configured or XDG_RUNTIME_DIR is missing.
  if (std::getenv("WAYLAND_DISPLAY") == nullptr &&
      (std::getenv("DISPLAY") != nullptr || std::getenv("XDG_RUNTIME_DIR") == nullptr)) {
    glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
  }
#endif
  if (glfwInit() != GLFW_TRUE) return windowError("no display to open a window on");
  nameLossOfServer();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  // We draw into our own framebuffer object and copy: the window needs no samples or depth.
  glfwWindowHint(GLFW_SAMPLES, 0);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, scaled ? GLFW_TRUE : GLFW_FALSE);
  GLFWwindow* window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (window == nullptr) {
    const Error error = windowError("cannot open a window with OpenGL 3.3");
    glfwTerminate();
    return error;
  }
  std::unique_ptr<Window> opened(new Window(window));
  opened->scaled_ = scaled;
  if (auto current = opened->makeCurrent(); !current) return current.error();
  return opened;
}

// Dear ImGui, initialized later, calls these callbacks from its own.
Window::Window(GLFWwindow* window) : window_(window) {
  glfwSetWindowUserPointer(window_, this);
  glfwSetKeyCallback(window_, onKey);
  glfwSetCursorPosCallback(window_, onMove);
  glfwSetMouseButtonCallback(window_, onButton);
  glfwSetScrollCallback(window_, onWheel);
  glfwSetWindowRefreshCallback(window_, onNews);
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* one, int, int) { onNews(one); });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* one, int) { onNews(one); });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* one, int) { onNews(one); });
  glfwSetDropCallback(window_, onDrop);
  glfwGetCursorPos(window_, &mouse_x_, &mouse_y_);
  answered_at_ = std::chrono::steady_clock::now();
}

void Window::takeLetters() {
  glfwSetCharCallback(window_, [](GLFWwindow* one, unsigned letter) {
    onNews(one);
    InputEvent event;
    event.kind = InputEvent::Kind::letter;
    event.letter = letter;
    of(one).input_.add(event);
  });
}

void Window::takeEvents(double most_s) {
  asked_at_ = std::chrono::steady_clock::now();
  if (most_s > 0) {
    glfwWaitEventsTimeout(most_s);
  } else {
    glfwPollEvents();
  }
  answered_at_ = std::chrono::steady_clock::now();
}

Window& Window::of(GLFWwindow* window) {
  return *static_cast<Window*>(glfwGetWindowUserPointer(window));
}

void Window::onKey(GLFWwindow* window, int key, int /*scancode*/, int action, int modifiers) {
  Window& self = of(window);
  self.news_ = true;
  if (action == GLFW_RELEASE) return;
  const KeyPress pressed{key, (modifiers & GLFW_MOD_SHIFT) != 0, action == GLFW_REPEAT,
                         (modifiers & GLFW_MOD_CONTROL) != 0};
  self.input_.add({InputEvent::Kind::key, 0, 0, 0, pressed});
}

void Window::onMove(GLFWwindow* window, double x, double y) {
  Window& self = of(window);
  self.news_ = true;
  self.mouse_x_ = x;
  self.mouse_y_ = y;
  self.input_.add({InputEvent::Kind::move, 0, x, y, {}});
}

// Use the pointer position of the event: GLFW would return the present one.
void Window::onButton(GLFWwindow* window, int button, int action, int /*modifiers*/) {
  Window& self = of(window);
  self.news_ = true;
  const auto kind = action == GLFW_PRESS ? InputEvent::Kind::press : InputEvent::Kind::release;
  InputEvent event{kind, static_cast<std::size_t>(button), self.mouse_x_, self.mouse_y_, {}};
  // What came while a frame was drawn is reported at once.
  constexpr std::chrono::milliseconds kAtOnce(5);
  event.to = std::chrono::steady_clock::now();
  event.from = event.to - self.asked_at_ < kAtOnce ? self.answered_at_ : event.to;
  self.input_.add(event);
}

void Window::onWheel(GLFWwindow* window, double /*across*/, double /*down*/) { onNews(window); }

void Window::onDrop(GLFWwindow* window, int count, const char** paths) {
  // More than anybody means to show.
  constexpr int kMaxFiles = 64;
  Window& self = of(window);
  self.news_ = true;
  for (int i = 0; i < std::min(count, kMaxFiles); ++i) self.dropped_.emplace_back(paths[i]);
}

void Window::onNews(GLFWwindow* window) { of(window).news_ = true; }

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

Status Window::makeCurrent() {
  last_glfw_error.clear();
  glfwMakeContextCurrent(window_);
  if (!last_glfw_error.empty()) return windowError("the window's OpenGL context is lost");
  return {};
}

GlProc Window::procAddress(const char* name) const { return glfwGetProcAddress(name); }

int Window::framebufferWidth() const {
  int width = 0;
  int height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  return width;
}

int Window::framebufferHeight() const {
  int width = 0;
  int height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  return height;
}

std::pair<int, int> Window::size() const {
  int width = 0;
  int height = 0;
  glfwGetWindowSize(window_, &width, &height);
  // As GLFW does it on X11, where a unit is a pixel.
  const bool in_pixels = width == framebufferWidth();
  const float scale = scaled_ && in_pixels ? std::max(1.0F, contentScale()) : 1.0F;
  return {static_cast<int>(static_cast<float>(width) / scale),
          static_cast<int>(static_cast<float>(height) / scale)};
}

float Window::contentScale() const {
  float across = 1;
  float down = 1;
  glfwGetWindowContentScale(window_, &across, &down);
  return down;
}

bool Window::followsPointer() const {
  return glfwGetWindowAttrib(window_, GLFW_HOVERED) == GLFW_TRUE ||
         glfwGetWindowAttrib(window_, GLFW_FOCUSED) == GLFW_TRUE;
}

void Window::resize(int width, int height) { glfwSetWindowSize(window_, width, height); }

void Window::hide() { glfwHideWindow(window_); }

void Window::setTitle(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

bool Window::closeRequested() const { return glfwWindowShouldClose(window_) == GLFW_TRUE; }
void Window::requestClose() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }
void Window::swap() { glfwSwapBuffers(window_); }
void Window::setPaced(bool paced) { glfwSwapInterval(paced ? 1 : 0); }

}  // namespace rocinante
