#pragma once

#include "core/cell/camera_lens.h"
#include "viewer/gl/gl_name.h"
#include "viewer/gl/shader_program.h"
#include "viewer/picture/pixel_rectangle.h"
#include "viewer/view/backdrop_frame.h"

namespace rocinante {

/// Draws a real camera's picture where a calibrated camera has it (fitOf), without depth. Keeps the
/// last picture as a texture. Its context must be current whenever it is used or destroyed.
class BackdropPass {
 public:
  static Result<BackdropPass> create(const GlTable& gl);

  /// Into the viewport, which is of this size. Blends by `opacity`; leaves depth test and blending
  /// off.
  void draw(const BackdropPicture& picture, const CameraIntrinsics& lens, int width, int height,
            double opacity);

 private:
  BackdropPass(const GlTable& gl, ShaderProgram program);
  void upload(const BackdropPicture& picture);

  const GlTable& gl_;
  ShaderProgram program_;
  GlVertexArray empty_array_{gl_};
  GlTexture texture_{gl_};
  std::uint64_t uploaded_ = 0;  ///< BackdropPicture::number; 0: none
};

}  // namespace rocinante
