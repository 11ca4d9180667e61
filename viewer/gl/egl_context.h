#pragma once

#include <memory>

#include "core/base/result.h"
#include "viewer/gl/render_context.h"

namespace rocinante {

/// Makes a context on a GPU (or Mesa's software renderer after pinRendererEnvironment()) without
/// display, by EGL_MESA_platform_surfaceless. libEGL is loaded on the first call; refused when it
/// is missing.
Result<std::unique_ptr<RenderContext>> makeEglContext();

}  // namespace rocinante
