#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "viewer/picture/picture.h"

namespace rocinante {

/// A picture of a real camera as a calibrated camera of the cell shows it: straightened.
struct BackdropPicture {
  std::uint64_t number = 0;     ///< another one for each picture of a process
  std::vector<Picture> levels;  ///< whole, then each half as large (mipmapsOf)
};

/// The picture of a moment; null when there is none then.
using BackdropAt = std::function<Result<std::shared_ptr<const BackdropPicture>>(LogTime)>;

/// Whether the views of a camera have the backdrop, which is of `backdrop_camera`; empty: there is
/// no backdrop.
inline bool hasBackdrop(std::string_view camera, std::string_view backdrop_camera) {
  return !backdrop_camera.empty() && camera == backdrop_camera;
}

/// Range of how much of a backdrop is drawn over the scene, besides all of it behind.
inline constexpr double kBackdropOpacity = 0.5;

}  // namespace rocinante
