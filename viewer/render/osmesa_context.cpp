// The one file that knows OSMesa, which newer Mesa drops.
#include "viewer/render/render_context.h"
// Last, because GL/osmesa.h brings in GL/gl.h, which hides the function types of glcorearb.h.
#include <GL/osmesa.h>

#include <array>

namespace rocinante {
namespace {

class OsmesaContext final : public RenderContext {
 public:
  explicit OsmesaContext(OSMesaContext context) : context_(context) {}
  ~OsmesaContext() override { OSMesaDestroyContext(context_); }

  Status makeCurrent() override {
    if (OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, kSide, kSide) != GL_TRUE) {
      return Error{ErrorKind::refused, "OSMesa cannot make its context current", {}};
    }
    return {};
  }

  GlProc procAddress(const char* name) const override { return OSMesaGetProcAddress(name); }
  std::string_view name() const override { return "OSMesa"; }

 private:
  // OSMesa wants a default framebuffer; nothing is ever drawn to it.
  static constexpr int kSide = 4;
  OSMesaContext context_;
  std::array<unsigned char, kSide * kSide * 4> pixels_{};
};

}  // namespace

Result<std::unique_ptr<RenderContext>> makeOsmesaContext() {
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
  OSMesaContext handle = OSMesaCreateContextAttribs(attributes.data(), nullptr);
  if (handle == nullptr) {
    return Error{ErrorKind::refused, "OSMesa gives no GL 3.3 core context", {}};
  }
  std::unique_ptr<RenderContext> context = std::make_unique<OsmesaContext>(handle);
  if (Status current = context->makeCurrent(); !current) return current.error();
  return context;
}

}  // namespace rocinante
