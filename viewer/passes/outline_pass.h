#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "viewer/gl/gl_name.h"
#include "viewer/gl/shader_program.h"
#include "viewer/passes/drawn_set.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// The outline's coverage by pixel, 0 to 255, from the pixels covered by the object (non-zero), row
/// by row. Two and a half pixels wide, times `scale` (0.5 to 4), outside of the object. On the CPU:
/// a shader took fifteen times as long in software, and integers are exact.
std::vector<std::uint8_t> outlineOf(const std::vector<std::uint8_t>& covered, int width, int height,
                                    double scale = 1);

/// Draws a line around all outlined items together (DrawItem::outlined), also where they are
/// hidden. Call find() before a frame's passes, then draw() over them. Its context must be current
/// whenever it is used or destroyed.
class OutlinePass {
 public:
  static Result<OutlinePass> create(const GlTable& gl);

  /// Draws the covered pixels into a separate buffer of the camera's size. Restores the framebuffer
  /// binding, not the viewport.
  Status find(std::span<const DrawnSet> sets, const Camera& camera, double scale);
  /// Draws the outline into the bound framebuffer; nothing when find() found nothing.
  void draw() const;

 private:
  OutlinePass(const GlTable& gl, ShaderProgram mask, ShaderProgram line);
  Status resize(int width, int height);
  void makeLine(double scale);

  const GlTable& gl_;
  ShaderProgram mask_, line_;
  GlVertexArray empty_array_{gl_};
  GlFramebuffer frame_;        // none until there is an outline
  GlTexture covered_, cover_;  // the same
  int width_ = 0, height_ = 0;
  bool found_ = false;
  /// Bounds of the covered pixels plus the line, in pixels from the bottom left.
  int left_ = 0, bottom_ = 0, right_ = 0, top_ = 0;
};

}  // namespace rocinante
