#include "viewer/gl/egl_context.h"

// Surfaceless EGL: a GPU on a machine without display. libEGL is loaded, not linked, so that
// programs start without it.
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>

#include <array>

#include "viewer/gl/hidden_drirc.h"

namespace rocinante {
namespace {

struct EglTable {
  PFNEGLGETPROCADDRESSPROC GetProcAddress = nullptr;
  PFNEGLINITIALIZEPROC Initialize = nullptr;
  PFNEGLBINDAPIPROC BindAPI = nullptr;
  PFNEGLCHOOSECONFIGPROC ChooseConfig = nullptr;
  PFNEGLCREATECONTEXTPROC CreateContext = nullptr;
  PFNEGLDESTROYCONTEXTPROC DestroyContext = nullptr;
  PFNEGLMAKECURRENTPROC MakeCurrent = nullptr;
  PFNEGLGETCURRENTCONTEXTPROC GetCurrentContext = nullptr;
  PFNEGLGETPLATFORMDISPLAYEXTPROC GetPlatformDisplayEXT = nullptr;
  PFNEGLQUERYDEVICESEXTPROC QueryDevicesEXT = nullptr;  // may be missing
};

Error refusal(std::string what) { return Error{ErrorKind::refused, std::move(what), {}}; }

Result<EglTable> loadEgl() {
  // Never closed, because drivers leave threads and exit handlers behind.
  void* library = ::dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return refusal("libEGL.so.1 is not installed");
  EglTable egl;
  egl.GetProcAddress =
      reinterpret_cast<PFNEGLGETPROCADDRESSPROC>(::dlsym(library, "eglGetProcAddress"));
  if (egl.GetProcAddress == nullptr) return refusal("libEGL.so.1 lacks eglGetProcAddress");
    // Core functions by dlsym: eglGetProcAddress need not know them before EGL 1.5.
#define ROCINANTE_EGL_FILL(type, name)                              \
  egl.name = reinterpret_cast<type>(::dlsym(library, "egl" #name)); \
  if (egl.name == nullptr) return refusal("libEGL.so.1 lacks egl" #name);
  ROCINANTE_EGL_FILL(PFNEGLINITIALIZEPROC, Initialize)
  ROCINANTE_EGL_FILL(PFNEGLBINDAPIPROC, BindAPI)
  ROCINANTE_EGL_FILL(PFNEGLCHOOSECONFIGPROC, ChooseConfig)
  ROCINANTE_EGL_FILL(PFNEGLCREATECONTEXTPROC, CreateContext)
  ROCINANTE_EGL_FILL(PFNEGLDESTROYCONTEXTPROC, DestroyContext)
  ROCINANTE_EGL_FILL(PFNEGLMAKECURRENTPROC, MakeCurrent)
  ROCINANTE_EGL_FILL(PFNEGLGETCURRENTCONTEXTPROC, GetCurrentContext)
#undef ROCINANTE_EGL_FILL
  egl.GetPlatformDisplayEXT = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      egl.GetProcAddress("eglGetPlatformDisplayEXT"));
  if (egl.GetPlatformDisplayEXT == nullptr) {
    return refusal("this EGL lacks EGL_EXT_platform_base");
  }
  egl.QueryDevicesEXT =
      reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl.GetProcAddress("eglQueryDevicesEXT"));
  return egl;
}

/// Without any surface: Mesa's platform, else the first device that works, for drivers that lack
/// that. EGL_NO_DISPLAY when there is none.
EGLDisplay openDisplay(const EglTable& egl) {
  const HiddenDrirc hidden;
  const auto opened = [&](EGLenum platform, void* native) -> EGLDisplay {
    EGLDisplay display = egl.GetPlatformDisplayEXT(platform, native, nullptr);
    const bool works =
        display != EGL_NO_DISPLAY && egl.Initialize(display, nullptr, nullptr) == EGL_TRUE;
    return works ? display : EGL_NO_DISPLAY;
  };
  EGLDisplay display = opened(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
  if (display != EGL_NO_DISPLAY || egl.QueryDevicesEXT == nullptr) return display;
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  if (egl.QueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count) !=
      EGL_TRUE) {
    return EGL_NO_DISPLAY;
  }
  for (EGLint i = 0; i < count && display == EGL_NO_DISPLAY; ++i) {
    display = opened(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(i)]);
  }
  return display;
}

class EglContext final : public RenderContext {
 public:
  EglContext(const EglTable& egl, EGLDisplay display, EGLContext context)
      : egl_(egl), display_(display), context_(context) {}

  ~EglContext() override {
    // Another of this thread may be the current one.
    if (egl_.GetCurrentContext() == context_) {
      egl_.MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    egl_.DestroyContext(display_, context_);
    // The display stays open: all contexts of the process share it.
  }

  Status makeCurrent() override {
    if (egl_.MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE) {
      return refusal("EGL cannot make its context current");
    }
    return {};
  }

  GlProc procAddress(const char* name) const override { return egl_.GetProcAddress(name); }
  std::string_view name() const override { return "EGL"; }

 private:
  EglTable egl_;
  EGLDisplay display_;
  EGLContext context_;
};

}  // namespace

Result<std::unique_ptr<RenderContext>> makeEglContext() {
  const Result<EglTable> egl = loadEgl();
  if (!egl) return egl.error();
  EGLDisplay display = openDisplay(*egl);
  if (display == EGL_NO_DISPLAY) return refusal("EGL has no surfaceless display here");
  if (egl->BindAPI(EGL_OPENGL_API) != EGL_TRUE) return refusal("this EGL has no desktop GL");
  const std::array<EGLint, 5> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0,
                                     EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (egl->ChooseConfig(display, wanted.data(), &config, 1, &count) != EGL_TRUE || count < 1) {
    return refusal("EGL has no configuration for desktop GL");
  }
  const std::array<EGLint, 7> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                         3,
                                         EGL_CONTEXT_MINOR_VERSION,
                                         3,
                                         EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                         EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                         EGL_NONE};
  EGLContext handle = egl->CreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
  if (handle == EGL_NO_CONTEXT) return refusal("EGL cannot create a GL 3.3 core context");
  std::unique_ptr<RenderContext> context = std::make_unique<EglContext>(*egl, display, handle);
  if (Status current = context->makeCurrent(); !current) return current.error();
  return context;
}

}  // namespace rocinante
