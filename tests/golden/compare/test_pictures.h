#pragma once

#include <algorithm>
#include <cstdint>

#include "viewer/picture/picture.h"

namespace rocinante {

/// A picture of one level in all four components.
inline Picture greyPicture(int width, int height, std::uint8_t level = 100) {
  Picture picture{width, height, {}};
  picture.rgba.assign(static_cast<std::size_t>(width * height) * 4, level);
  return picture;
}

/// An opaque picture of one colour.
inline Picture plainPicture(int width, int height, std::uint8_t red, std::uint8_t green,
                            std::uint8_t blue) {
  Picture picture{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    for (const std::uint8_t component : {red, green, blue, std::uint8_t{255}}) {
      picture.rgba.push_back(component);
    }
  }
  return picture;
}

/// Opaque noise, the same for the same seed.
inline Picture noisePicture(int width, int height, std::uint32_t seed) {
  Picture picture = greyPicture(width, height, 255);
  for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
    seed = seed * 1664525U + 1013904223U;
    if (i % 4 != 3) picture.rgba[i] = static_cast<std::uint8_t>(seed >> 24U);
  }
  return picture;
}

inline std::uint8_t* pixelAt(Picture& picture, int x, int y) {
  return picture.rgba.data() + static_cast<std::ptrdiff_t>((y * picture.width + x) * 4);
}

}  // namespace rocinante
