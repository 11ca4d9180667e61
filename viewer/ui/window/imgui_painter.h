#pragma once

#include <memory>
#include <optional>

#include "core/base/result.h"
#include "viewer/gl/gl_table.h"
#include "viewer/picture/pixel_rectangle.h"

struct ImDrawData;

namespace rocinante {

/// Draws Dear ImGui's triangles through our GL table into the bound framebuffer, so that the
/// interface is in the same framebuffer object as the scene and can be judged like it. Its context
/// must be current whenever it is used or destroyed.
class ImguiPainter {
 public:
  /// Builds the font texture of the current ImGui context; call after adding the fonts.
  static Result<ImguiPainter> create(const GlTable& gl);

  ~ImguiPainter();
  ImguiPainter(ImguiPainter&&) noexcept;
  ImguiPainter& operator=(ImguiPainter&&) noexcept;

  /// Uploads the font texture again after the fonts changed, or for another ImGui context.
  void refreshFont();

  /// Pixels of the bound framebuffer, which is `height` high, y up in GL; with `only` within that.
  void draw(const ImDrawData& data, int width, int height,
            const std::optional<PixelRectangle>& only = {});

 private:
  struct Impl;
  explicit ImguiPainter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
