#pragma once

#include <string>

#include "viewer/picture/pixel_rectangle.h"
#include "viewer/view/camera.h"

namespace rocinante {

/// A part of a picture with its own camera: the main view or an inset.
struct PicturedView {
  bool is_inset = false;
  std::string camera;   ///< the inset's name; for the main view as requested
  PixelRectangle part;  ///< the main view's is the whole picture
  CameraView from;
};

}  // namespace rocinante
