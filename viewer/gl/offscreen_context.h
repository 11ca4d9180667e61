#pragma once

#include <memory>

#include "viewer/gl/render_context.h"
#include "viewer/gl/renderer_key.h"

namespace rocinante {

/// The library that makes contexts without a window: "osmesa" or "egl", or empty for the first that
/// works. A frame's bits do not depend on it. Set by --context.
inline constexpr const char* kContextVariable = "ROCINANTE_CONTEXT";

/// A context without display, current in this thread. The reproducible profile prefers OSMesa, the
/// fast profile, which may use a GPU, prefers EGL; kContextVariable overrides both. refused, with
/// what to install, when none works. Mesa reads its environment when the first context is made: see
/// pinRendererEnvironment().
Result<std::unique_ptr<RenderContext>> makeOffscreenContext(Profile profile);

}  // namespace rocinante
