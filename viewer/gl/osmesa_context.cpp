// The only file that uses OSMesa, which newer Mesa drops. It is loaded, not linked, so that
// programs start without it and can report it.
#include "viewer/gl/osmesa_context.h"
// Last, because GL/osmesa.h brings in GL/gl.h, which hides the function types of glcorearb.h.
#include <GL/osmesa.h>
#include <dlfcn.h>

#include <array>

namespace rocinante {
namespace {

/// The file name of current OSMesa.
constexpr const char* kLibrary = "libOSMesa.so.8";

struct OsmesaTable {
  decltype(&OSMesaCreateContextAttribs) CreateContextAttribs = nullptr;
  decltype(&OSMesaDestroyContext) DestroyContext = nullptr;
  decltype(&OSMesaMakeCurrent) MakeCurrent = nullptr;
  decltype(&OSMesaGetProcAddress) GetProcAddress = nullptr;
};

Result<OsmesaTable> loadOsmesa() {
  // Never closed: drivers leave threads and exit handlers behind.
  void* library = ::dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    const char* reason = ::dlerror();
    return Error{
        ErrorKind::refused,
        std::string("OSMesa cannot be loaded: ") + (reason != nullptr ? reason : "no reason given"),
        {}};
  }
  OsmesaTable osmesa;
#define ROCINANTE_OSMESA_FILL(name)                                                        \
  osmesa.name = reinterpret_cast<decltype(osmesa.name)>(::dlsym(library, "OSMesa" #name)); \
  if (osmesa.name == nullptr) {                                                            \
    return Error{ErrorKind::refused, std::string(kLibrary) + " lacks OSMesa" #name, {}};   \
  }
  ROCINANTE_OSMESA_FILL(CreateContextAttribs)
  ROCINANTE_OSMESA_FILL(DestroyContext)
  ROCINANTE_OSMESA_FILL(MakeCurrent)
  ROCINANTE_OSMESA_FILL(GetProcAddress)
#undef ROCINANTE_OSMESA_FILL
  return osmesa;
}

class OsmesaContext final : public RenderContext {
 public:
  OsmesaContext(const OsmesaTable& osmesa, OSMesaContext context)
      : osmesa_(osmesa), context_(context) {}
  ~OsmesaContext() override { osmesa_.DestroyContext(context_); }

  Status makeCurrent() override {
    if (osmesa_.MakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, kSide, kSide) != GL_TRUE) {
      return Error{ErrorKind::refused, "OSMesa cannot make its context current", {}};
    }
    return {};
  }

  GlProc procAddress(const char* name) const override { return osmesa_.GetProcAddress(name); }
  std::string_view name() const override { return "OSMesa"; }

 private:
  // OSMesa requires a default framebuffer; nothing is drawn to it.
  static constexpr int kSide = 4;
  OsmesaTable osmesa_;
  OSMesaContext context_;
  std::array<unsigned char, kSide * kSide * 4> pixels_{};
};

}  // namespace

Result<std::unique_ptr<RenderContext>> makeOsmesaContext() {
  const Result<OsmesaTable> osmesa = loadOsmesa();
  if (!osmesa) return osmesa.error();
  const std::array attributes{OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              0,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              3,
                              0};
  OSMesaContext handle = osmesa->CreateContextAttribs(attributes.data(), nullptr);
  if (handle == nullptr) {
    return Error{ErrorKind::refused, "OSMesa cannot create a GL 3.3 core context", {}};
  }
  std::unique_ptr<RenderContext> context = std::make_unique<OsmesaContext>(*osmesa, handle);
  if (Status current = context->makeCurrent(); !current) return current.error();
  return context;
}

}  // namespace rocinante
