// The functions themselves, which the linker finds in emscripten's library.
#define GL_GLEXT_PROTOTYPES

#include "viewer/web/web_context.h"

#include <emscripten.h>
#include <emscripten/html5.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>

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

/// Answers here what a browser answers only once all that was drawn before is done: a question a
/// frame, and nothing is drawn beside what computes. Of the page's only context.
namespace known {

GLuint bound_frame = 0, bound_buffer = 0;
std::map<GLuint, GLint> buffer_samples, frame_samples;  // by name
std::set<GLuint> frames_of_textures;
std::map<GLenum, GLint> limits;
bool is_much_allocated = false;                         // since GetError() asked
constexpr std::int64_t kMuch = std::int64_t{1} << 26U;  // bytes

void APIENTRY bindFramebuffer(GLenum target, GLuint name) {
  if (target != GL_READ_FRAMEBUFFER) bound_frame = name;
  glBindFramebuffer(target, name);
}
void APIENTRY bindRenderbuffer(GLenum target, GLuint name) {
  bound_buffer = name;
  glBindRenderbuffer(target, name);
}
void APIENTRY renderbufferStorageMultisample(GLenum target, GLsizei samples, GLenum format,
                                             GLsizei width, GLsizei height) {
  buffer_samples[bound_buffer] = samples;
  if (std::int64_t{4} * width * height * std::max(samples, 1) > kMuch) is_much_allocated = true;
  glRenderbufferStorageMultisample(target, samples, format, width, height);
}
void APIENTRY framebufferRenderbuffer(GLenum target, GLenum attachment, GLenum buffer_target,
                                      GLuint name) {
  frame_samples[bound_frame] = buffer_samples[name];
  glFramebufferRenderbuffer(target, attachment, buffer_target, name);
}
void APIENTRY framebufferTexture2D(GLenum target, GLenum attachment, GLenum texture_target,
                                   GLuint name, GLint level) {
  frame_samples[bound_frame] = 0;
  frames_of_textures.insert(bound_frame);
  glFramebufferTexture2D(target, attachment, texture_target, name, level);
}

/// Of renderbuffers there are two kinds here, which every WebGL 2 draws to.
GLenum APIENTRY checkFramebufferStatus(GLenum target) {
  if (!frames_of_textures.contains(bound_frame)) return GL_FRAMEBUFFER_COMPLETE;
  return glCheckFramebufferStatus(target);
}

/// A browser may give more samples than asked for, which harms nothing.
void APIENTRY getRenderbufferParameteriv(GLenum target, GLenum what, GLint* value) {
  if (what == GL_RENDERBUFFER_SAMPLES) {
    *value = buffer_samples[bound_buffer];
  } else {
    glGetRenderbufferParameteriv(target, what, value);
  }
}

void APIENTRY getIntegerv(GLenum what, GLint* value) {
  switch (what) {
    case GL_DRAW_FRAMEBUFFER_BINDING:
      *value = static_cast<GLint>(bound_frame);
      return;
    case GL_SAMPLES:
      *value = frame_samples[bound_frame];
      return;
    case GL_MAX_RENDERBUFFER_SIZE:
    case GL_MAX_SAMPLES:
    case GL_MAX_TEXTURE_SIZE:
      if (const auto [at, is_new] = limits.try_emplace(what, 0); is_new) {
        glGetIntegerv(what, &at->second);
      }
      *value = limits[what];
      return;
    default:
      glGetIntegerv(what, value);
  }
}

/// What is drawn wrongly the browser's console tells; whether there is much memory is asked for.
GLenum APIENTRY getError() {
  if (!is_much_allocated) return GL_NO_ERROR;
  is_much_allocated = false;
  return glGetError();
}

GlProc find(const char* name) {
  const std::map<std::string_view, GlProc> functions{
      {"glBindFramebuffer", reinterpret_cast<GlProc>(&bindFramebuffer)},
      {"glBindRenderbuffer", reinterpret_cast<GlProc>(&bindRenderbuffer)},
      {"glRenderbufferStorageMultisample",
       reinterpret_cast<GlProc>(&renderbufferStorageMultisample)},
      {"glFramebufferRenderbuffer", reinterpret_cast<GlProc>(&framebufferRenderbuffer)},
      {"glFramebufferTexture2D", reinterpret_cast<GlProc>(&framebufferTexture2D)},
      {"glCheckFramebufferStatus", reinterpret_cast<GlProc>(&checkFramebufferStatus)},
      {"glGetRenderbufferParameteriv", reinterpret_cast<GlProc>(&getRenderbufferParameteriv)},
      {"glGetIntegerv", reinterpret_cast<GlProc>(&getIntegerv)},
      {"glGetError", reinterpret_cast<GlProc>(&getError)},
  };
  const auto found = functions.find(name);
  return found == functions.end() ? nullptr : found->second;
}

}  // namespace known

class WebContext final : public RenderContext {
 public:
  explicit WebContext(EMSCRIPTEN_WEBGL_CONTEXT_HANDLE handle) : handle_(handle) {}
  ~WebContext() override { emscripten_webgl_destroy_context(handle_); }

  Status makeCurrent() override {
    if (emscripten_webgl_make_context_current(handle_) == EMSCRIPTEN_RESULT_SUCCESS) return {};
    return Error{ErrorKind::refused, "the browser has taken its WebGL 2 back", {}};
  }

  GlProc procAddress(const char* name) const override {
    if (const GlProc mine = known::find(name); mine != nullptr) return mine;
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
  // Each is a question to the browser's renderer; these are what is used, besides clip control.
  attributes.enableExtensionsByDefault = EM_FALSE;
  const auto handle = emscripten_webgl_create_context(kCanvas, &attributes);
  if (handle <= 0) {
    return Error{ErrorKind::refused, "this browser has no WebGL 2, which the picture needs", {}};
  }
  for (const char* name : {"EXT_color_buffer_float", "EXT_depth_clamp"}) {
    emscripten_webgl_enable_extension(handle, name);
  }
  std::unique_ptr<RenderContext> context = std::make_unique<WebContext>(handle);
  if (Status current = context->makeCurrent(); !current) return current.error();
  return context;
}

}  // namespace rocinante
