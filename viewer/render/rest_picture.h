#pragma once

#include <cstdint>
#include <optional>

#include "viewer/gl/frame_buffer.h"
#include "viewer/render/renderer.h"

namespace rocinante {

/// A frame with everything, at full resolution and with all samples, drawn in slices of rows from
/// the top: the pixels of ScaledView's rung 0. Its context must be current whenever it is used or
/// destroyed.
class RestPicture {
 public:
  /// Draws `rows` rows below the first `drawn`; with the last row the picture is whole and
  /// resolved. The frame must be the same for all slices of a picture.
  Status drawRows(Renderer& renderer, SceneFrame frame, int width, int height, int samples,
                  int drawn, int rows);

  /// Whole since the slice with its last row; one sample per pixel.
  const FrameBuffer& picture() const { return *picture_; }

 private:
  std::optional<FrameBuffer> picture_;  ///< made by the first slice of its size
  std::uint64_t frames_drawn_ = 0;      ///< of the renderer, since the last slice
};

}  // namespace rocinante
