#pragma once

#include <memory>

#include "core/base/result.h"
#include "viewer/gl/render_context.h"

namespace rocinante {

/// Software rendering without display or GPU. The library, which Mesa dropped in 25.1, is loaded on
/// the first call; refused when it is missing. Only in a build with ROCINANTE_OSMESA: call
/// makeOffscreenContext() instead.
Result<std::unique_ptr<RenderContext>> makeOsmesaContext();

}  // namespace rocinante
