#pragma once

#include "core/model/cell.h"
#include "viewer/render/shader_program.h"

namespace rocinante {

/// Fills whatever framebuffer is bound with the cell's gradient, between DrawPasses::begin() and
/// end(). Its context must be current whenever it is used or destroyed.
class BackgroundPass {
 public:
  static Result<BackgroundPass> create(const GlTable& gl);
  ~BackgroundPass();
  BackgroundPass(BackgroundPass&& other) noexcept;
  BackgroundPass& operator=(BackgroundPass&&) = delete;

  void draw(const CellScene& look) const;

 private:
  BackgroundPass(const GlTable& gl, ShaderProgram program);

  const GlTable& gl_;
  ShaderProgram program_;
  GLuint empty_array_ = 0;
};

}  // namespace rocinante
