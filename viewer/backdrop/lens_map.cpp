#include "viewer/backdrop/lens_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rocinante {

LensMap::LensMap(const CameraIntrinsics& lens, const LensDistortion& distortion, int width,
                 int height)
    : width_(width), height_(height) {
  const double across = static_cast<double>(width) / lens.width;
  const double down = static_cast<double>(height) / lens.height;
  const double fx = lens.fx * across, fy = lens.fy * down;
  // The edge of a picture lies half a pixel before the centre of its pixel 0.
  const double cx = (lens.cx + 0.5) * across - 0.5, cy = (lens.cy + 0.5) * down - 0.5;
  const auto& [k1, k2, p1, p2, k3] = distortion;
  places_.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int v = 0; v < height; ++v) {
    const double y = (v - cy) / fy;
    for (int u = 0; u < width; ++u) {
      const double x = (u - cx) / fx;
      const double r2 = x * x + y * y;
      const double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
      const double bent_x = x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x);
      const double bent_y = y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y;
      places_.push_back(placeOf(bent_x * fx + cx, bent_y * fy + cy));
    }
  }
}

LensMap::Place LensMap::placeOf(double x, double y) const {
  if (!(x >= -0.5 && y >= -0.5 && x <= width_ - 0.5 && y <= height_ - 0.5)) return {};
  const double within_x = std::clamp(x, 0.0, width_ - 1.0);
  const double within_y = std::clamp(y, 0.0, height_ - 1.0);
  const auto steps_x = static_cast<int>(within_x * 256 + 0.5);
  const auto steps_y = static_cast<int>(within_y * 256 + 0.5);
  return {static_cast<std::int16_t>(steps_x / 256), static_cast<std::int16_t>(steps_y / 256),
          static_cast<std::uint8_t>(steps_x % 256), static_cast<std::uint8_t>(steps_y % 256)};
}

Picture LensMap::straightened(const Picture& picture) const {
  Picture made{width_, height_, std::vector<std::uint8_t>(picture.rgba.size())};
  std::uint8_t* out = made.rgba.data();
  const auto row = static_cast<std::size_t>(width_) * 4;
  for (const Place& place : places_) {
    if (place.x >= 0) {
      const std::size_t right_of = place.right > 0 ? 4 : 0;
      const std::size_t below = place.lower > 0 ? row : 0;
      const std::uint8_t* from = picture.rgba.data() + static_cast<std::size_t>(place.y) * row +
                                 static_cast<std::size_t>(place.x) * 4;
      const unsigned right = place.right, lower = place.lower;
      for (std::size_t k = 0; k < 4; ++k) {
        const unsigned upper_mix = from[k] * (256 - right) + from[k + right_of] * right;
        const unsigned lower_mix =
            from[k + below] * (256 - right) + from[k + below + right_of] * right;
        out[k] = static_cast<std::uint8_t>(
            (upper_mix * (256 - lower) + lower_mix * lower + (1U << 15U)) >> 16U);
      }
    }
    out += 4;
  }
  return made;
}

}  // namespace rocinante
