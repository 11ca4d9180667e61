#pragma once

#include <algorithm>

#include "core/cell/camera_lens.h"

namespace rocinante {

/// Where a calibrated picture lies in a drawn one: as large as fits, in the middle. Its left edge,
/// half a pixel before the centre of its pixel 0, is at `left`.
struct LensFit {
  double left = 0, top = 0;  ///< in pixels of the drawn picture
  double scale = 1;          ///< pixels of the drawn picture per calibrated one

  double right(const CameraIntrinsics& lens) const { return left + scale * lens.width; }
  double bottom(const CameraIntrinsics& lens) const { return top + scale * lens.height; }
};

inline LensFit fitOf(const CameraIntrinsics& lens, int width, int height) {
  const double scale =
      std::min(static_cast<double>(width) / lens.width, static_cast<double>(height) / lens.height);
  return {(width - scale * lens.width) / 2, (height - scale * lens.height) / 2, scale};
}

}  // namespace rocinante
