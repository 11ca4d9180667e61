// The floor of a window's first panel: a window with a GL 3.3 context by GLFW that is cleared and
// shown once, and nothing else. Prints the steady clock in nanoseconds when it is shown; to
// standard error, which GL it is: vendor, renderer and version, a line each. usage: bare_window
// WIDTH HEIGHT
#define GLFW_INCLUDE_NONE
#include <GL/glcorearb.h>
#include <GLFW/glfw3.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>

namespace {

int failed() {
  const char* why = nullptr;
  glfwGetError(&why);
  std::fprintf(stderr, "bare_window: %s\n", why != nullptr ? why : "WIDTH HEIGHT are missing");
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 || glfwInit() != GLFW_TRUE) return failed();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  GLFWwindow* const window =
      glfwCreateWindow(std::atoi(argv[1]), std::atoi(argv[2]), "bare", nullptr, nullptr);
  if (window == nullptr) return failed();
  glfwMakeContextCurrent(window);
  reinterpret_cast<PFNGLCLEARPROC>(glfwGetProcAddress("glClear"))(GL_COLOR_BUFFER_BIT);
  glfwSwapBuffers(window);
  const auto shown = std::chrono::steady_clock::now().time_since_epoch();
  std::printf("%lld\n", static_cast<long long>(
                            std::chrono::duration_cast<std::chrono::nanoseconds>(shown).count()));
  const auto text = reinterpret_cast<PFNGLGETSTRINGPROC>(glfwGetProcAddress("glGetString"));
  for (const GLenum name : {GL_VENDOR, GL_RENDERER, GL_VERSION}) {
    std::fprintf(stderr, "%s\n", reinterpret_cast<const char*>(text(name)));
  }
  glfwTerminate();
  return 0;
}
