#include "viewer/gl/gl_table.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

namespace rocinante {

bool isSoftwareRenderer(std::string_view renderer) {
  static constexpr std::array<std::string_view, 6> kNames{
      "llvmpipe", "softpipe", "swrast", "Software Rasterizer", "SwiftShader", "Basic Render"};
  return std::ranges::any_of(
      kNames, [&](std::string_view name) { return renderer.find(name) != std::string_view::npos; });
}

bool GlTable::hasExtension(const char* name) const {
  GLint count = 0;
  GetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i) {
    const auto* extension =
        reinterpret_cast<const char*>(GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
    if (extension != nullptr && std::strcmp(extension, name) == 0) return true;
  }
  return false;
}

Result<GlTable> fillGlTable(const GlProcFinder& find) {
  GlTable gl;
#define ROCINANTE_GL_FILL(type, name)                                                          \
  gl.name = reinterpret_cast<type>(find("gl" #name));                                          \
  if (gl.name == nullptr) {                                                                    \
    return Error{ErrorKind::refused, "the GL driver lacks gl" #name ", which GL 3.3 has", {}}; \
  }
  ROCINANTE_GL_FUNCTIONS(ROCINANTE_GL_FILL)
#undef ROCINANTE_GL_FILL

  GLint major = 0;
  GLint minor = 0;
  gl.GetIntegerv(GL_MAJOR_VERSION, &major);
  gl.GetIntegerv(GL_MINOR_VERSION, &minor);
  const auto* const version = reinterpret_cast<const char*>(gl.GetString(GL_VERSION));
  const auto* const renderer = reinterpret_cast<const char*>(gl.GetString(GL_RENDERER));
  gl.is_software = renderer != nullptr && isSoftwareRenderer(renderer);
  gl.is_embedded = version != nullptr && std::string_view(version).starts_with("OpenGL ES");
  if (major * 10 + minor < (gl.is_embedded ? 30 : 33)) {
    return Error{ErrorKind::refused,
                 "GL 3.3 or OpenGL ES 3.0 is required, but this context is " +
                     std::string(gl.is_embedded ? "ES " : "") + std::to_string(major) + "." +
                     std::to_string(minor),
                 {}};
  }
  if (gl.is_embedded) {
    // Both are extensions there, whose functions are found only where they work.
    gl.ClipControl = reinterpret_cast<PFNGLCLIPCONTROLPROC>(find("glClipControl"));
    gl.clamps_depth = gl.hasExtension("GL_EXT_depth_clamp");
    return gl;
  }
  // A driver may return addresses of unsupported functions, so check the feature first.
  if (major * 10 + minor >= 45 || gl.hasExtension("GL_ARB_clip_control")) {
    gl.ClipControl = reinterpret_cast<PFNGLCLIPCONTROLPROC>(find("glClipControl"));
  }
  return gl;
}

}  // namespace rocinante
