#pragma once

#include <memory>

#include "core/base/result.h"
#include "viewer/gl/render_context.h"

namespace rocinante {

/// WebGL 2 of the page's canvas `#rocinante-canvas`, current in the page's only thread. Its default
/// framebuffer is what the page shows. refused when the browser has none.
Result<std::unique_ptr<RenderContext>> makeWebContext();

}  // namespace rocinante
