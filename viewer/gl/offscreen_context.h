#pragma once

#include <memory>

#include "viewer/gl/render_context.h"
#include "viewer/gl/renderer_key.h"

namespace rocinante {

/// Which library makes contexts without a window: "osmesa" or "egl", or empty for the first that
/// works. A frame's bits do not depend on it. What --context of every program sets.
inline constexpr const char* kContextVariable = "ROCINANTE_CONTEXT";

/// A context without display, current in this thread. The reproducible profile prefers OSMesa to
/// EGL without a surface, the fast one, which may use a GPU, EGL to OSMesa; kContextVariable
/// outranks both. refused, with what to install, where none of them works. Mesa reads its
/// environment when the first context is made: see pinRendererEnvironment().
Result<std::unique_ptr<RenderContext>> makeOffscreenContext(Profile profile);

}  // namespace rocinante
