// The functions themselves, which the linker finds in emscripten's library.
#define GL_GLEXT_PROTOTYPES

#include "viewer/web/web_context.h"

#include <emscripten.h>
#include <emscripten/html5.h>

#include <cstring>

// What WebGL 2 has under another name, or lacks.
extern "C" {
void glClearDepthf(GLfloat depth);
void glClearDepth(GLdouble depth) { glClearDepthf(static_cast<GLfloat>(depth)); }
void glDrawBuffer(GLenum buffer) { glDrawBuffers(1, &buffer); }
// Of the window's panels alone, which no page has.
void glDrawElementsBaseVertex(GLenum, GLsizei, GLenum, const void*, GLint) {}
}

namespace rocinante {
namespace {

constexpr const char* kCanvas = "#rocinante-canvas";

// clang-format off
EM_JS(int, hasClipControl, (), {
  Module.clipControl = GLctx.getExtension("EXT_clip_control");
  return Module.clipControl ? 1 : 0;
});
EM_JS(void, setClipControl, (unsigned origin, unsigned depth), {
  Module.clipControl.clipControlEXT(origin, depth);
});
// clang-format on

class WebContext final : public RenderContext {
 public:
  explicit WebContext(EMSCRIPTEN_WEBGL_CONTEXT_HANDLE handle) : handle_(handle) {}
  ~WebContext() override { emscripten_webgl_destroy_context(handle_); }

  Status makeCurrent() override {
    if (emscripten_webgl_make_context_current(handle_) == EMSCRIPTEN_RESULT_SUCCESS) return {};
    return Error{ErrorKind::refused, "the browser has taken its WebGL 2 back", {}};
  }

  GlProc procAddress(const char* name) const override {
#define ROCINANTE_GL_FIND(type, function)             \
  if (std::strcmp(name, "gl" #function) == 0) {       \
    return reinterpret_cast<GlProc>(&::gl##function); \
  }
    ROCINANTE_GL_FUNCTIONS(ROCINANTE_GL_FIND)
#undef ROCINANTE_GL_FIND
    if (std::strcmp(name, "glClipControl") == 0 && hasClipControl() != 0) {
      return reinterpret_cast<GlProc>(&setClipControl);
    }
    return nullptr;
  }
  std::string_view name() const override { return "WebGL"; }

 private:
  EMSCRIPTEN_WEBGL_CONTEXT_HANDLE handle_;
};

}  // namespace

Result<std::unique_ptr<RenderContext>> makeWebContext() {
  EmscriptenWebGLContextAttributes attributes;
  emscripten_webgl_init_context_attributes(&attributes);
  attributes.majorVersion = 2;
  // Frames are drawn into framebuffers of our own and copied: the canvas needs neither.
  attributes.alpha = EM_FALSE;
  attributes.depth = EM_FALSE;
  attributes.antialias = EM_FALSE;
  attributes.preserveDrawingBuffer = EM_TRUE;  // a paused page is drawn once
  const auto handle = emscripten_webgl_create_context(kCanvas, &attributes);
  if (handle <= 0) {
    return Error{ErrorKind::refused, "this browser has no WebGL 2, which the picture needs", {}};
  }
  std::unique_ptr<RenderContext> context = std::make_unique<WebContext>(handle);
  if (Status current = context->makeCurrent(); !current) return current.error();
  return context;
}

}  // namespace rocinante
