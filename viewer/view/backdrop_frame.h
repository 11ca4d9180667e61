#pragma once

#include <cstdint>
#include <functional>
#include <memory>
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

/// Range of how much of a backdrop is drawn over the scene, besides all of it behind.
inline constexpr double kBackdropOpacity = 0.5;

}  // namespace rocinante
