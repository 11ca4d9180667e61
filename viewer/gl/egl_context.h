#pragma once

#include <memory>

#include "core/base/result.h"
#include "viewer/gl/render_context.h"

namespace rocinante {

/// A GPU (or Mesa's software, where pinRendererEnvironment() was called) without display, by
/// EGL_MESA_platform_surfaceless. libEGL is loaded on the first call; refused where there is none.
Result<std::unique_ptr<RenderContext>> makeEglContext();

}  // namespace rocinante
