#pragma once

#include <string_view>

#include "core/base/result.h"
#include "viewer/gl/gl_table.h"

namespace rocinante {

/// A GL 3.3 core context of OSMesa, surfaceless EGL or a window. Frames are drawn into our own
/// framebuffer objects, so the context's default framebuffer does not matter. Bound to one thread
/// at a time: the one that called makeCurrent() last.
class RenderContext {
 public:
  RenderContext() = default;
  virtual ~RenderContext() = default;
  RenderContext(const RenderContext&) = delete;
  RenderContext& operator=(const RenderContext&) = delete;

  virtual Status makeCurrent() = 0;
  /// Null when the driver lacks the function.
  virtual GlProc procAddress(const char* name) const = 0;
  /// "OSMesa", "EGL", "GLFW", for messages.
  virtual std::string_view name() const = 0;
};

}  // namespace rocinante
