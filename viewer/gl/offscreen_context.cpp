#include "viewer/gl/offscreen_context.h"

#include <stdlib.h>

#include <string_view>

#include "viewer/gl/egl_context.h"
#include "viewer/gl/osmesa_context.h"

namespace rocinante {
namespace {

#if !ROCINANTE_OSMESA
Error notBuiltIn() {
  return Error{ErrorKind::refused, "this build has no OSMesa (-DROCINANTE_OSMESA=OFF)", {}};
}
#endif

Result<std::unique_ptr<RenderContext>> makeOsmesa() {
#if ROCINANTE_OSMESA
  return makeOsmesaContext();
#else
  return notBuiltIn();
#endif
}

}  // namespace

Result<std::unique_ptr<RenderContext>> makeOffscreenContext(Profile profile) {
  const char* variable = ::getenv(kContextVariable);
  const std::string_view wanted = variable == nullptr ? "" : variable;
  if (wanted == "osmesa") return makeOsmesa();
  if (wanted == "egl") return makeEglContext();
  if (!wanted.empty()) {
    return Error{ErrorKind::bad_argument,
                 std::string(kContextVariable) + " is \"" + std::string(wanted) +
                     "\", and may be osmesa or egl",
                 {}};
  }
  const bool egl_first = profile == Profile::fast;
  auto first = egl_first ? makeEglContext() : makeOsmesa();
  if (first) return first;
  auto second = egl_first ? makeOsmesa() : makeEglContext();
  if (second) return second;
  return Error{ErrorKind::refused,
               "drawing without a display needs EGL (Debian's libegl1 and libegl-mesa0) or OSMesa "
               "(libosmesa6): " +
                   first.error().what + "; " + second.error().what,
               {}};
}

}  // namespace rocinante
