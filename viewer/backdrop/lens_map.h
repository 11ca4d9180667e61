#pragma once

#include <cstdint>
#include <vector>

#include "core/cell/camera_lens.h"
#include "viewer/picture/picture.h"

namespace rocinante {

/// Straightens pictures of one size: each pixel of the result, which the lens without distortion
/// has, is taken from where the real lens has it, bilinearly; transparent where that is outside.
/// The same bytes on every processor.
class LensMap {
 public:
  /// For pictures of this size, which may be another than the lens's.
  LensMap(const CameraIntrinsics& lens, const LensDistortion& distortion, int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  /// `picture` has the map's size.
  Picture straightened(const Picture& picture) const;

 private:
  /// The upper left of the four pixels that are mixed, and how much of the right and lower ones, in
  /// 256ths. `x` is -1 for a transparent pixel.
  struct Place {
    std::int16_t x = -1, y = -1;
    std::uint8_t right = 0, lower = 0;
  };
  Place placeOf(double x, double y) const;

  int width_, height_;
  std::vector<Place> places_;
};

}  // namespace rocinante
