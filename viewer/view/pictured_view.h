#pragma once

#include <string>

#include "viewer/picture/pixel_rectangle.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// A part of a picture with a camera of its own: the main view, or an inset over it.
struct PicturedView {
  bool is_inset = false;
  std::string camera;   ///< by name, as the inset has it; of the main view as it was asked for
  PixelRectangle part;  ///< the main view's is the whole picture
  CameraView from;
};

}  // namespace rocinante
