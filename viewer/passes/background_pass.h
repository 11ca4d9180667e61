#pragma once

#include <optional>
#include <vector>

#include "core/cell/cell.h"
#include "viewer/gl/gl_name.h"
#include "viewer/gl/shader_program.h"
#include "viewer/picture/pixel_rectangle.h"

namespace rocinante {

/// Fills a part of the bound framebuffer with the cell's gradient. Each gradient is drawn once and
/// copied into later frames, which takes a quarter of the time in software. Its context must be
/// current whenever it is used or destroyed.
class BackgroundPass {
 public:
  /// Begins its program.
  explicit BackgroundPass(const GlTable& gl);

  /// Required before it draws; waits for the driver on first use.
  Status prepare();

  /// Overwrites colour and alpha of the part in RGBA8, with `only` of what lies in both; keeps its
  /// depths. Leaves viewport and scissor so (setViewport).
  void draw(const CellScene& look, const PixelRectangle& part, int frame_height,
            const std::optional<PixelRectangle>& only = {});

 private:
  /// A gradient in its own framebuffer.
  struct Kept {
    glm::vec3 top, bottom;
    int width = 0, height = 0;
    GLint samples = 0;
    GlFramebuffer frame;
    GlRenderbuffer color;
  };
  static constexpr std::size_t kKept = 4;                             // a view and its insets
  static constexpr std::int64_t kKeptBytes = std::int64_t{64} << 20;  // of one of them

  void drawGradient(const CellScene& look) const;
  const Kept* kept(const CellScene& look, int width, int height, GLint samples, GLuint bound);

  const GlTable& gl_;
  ShaderProgram program_;
  bool ready_ = false;
  GlVertexArray empty_array_{gl_};
  std::vector<Kept> kept_;
};

}  // namespace rocinante
