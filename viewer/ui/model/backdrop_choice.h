#pragma once

#include <memory>
#include <string>

#include "core/base/time.h"
#include "viewer/view/backdrop_frame.h"

namespace rocinante {

/// How the pictures of a real camera are shown, and the present one.
struct BackdropChoice {
  std::string camera;  ///< of the cell: its views have them
  bool shown = true;
  double opacity = kBackdropOpacity;                 ///< over the model, 0 to 1
  Nanoseconds offset{0};                             ///< session time of their time zero
  std::shared_ptr<const BackdropPicture> picture{};  ///< null: there is none at this moment
};

}  // namespace rocinante
