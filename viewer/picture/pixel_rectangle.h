#pragma once

namespace rocinante {

/// Part of a picture, in pixels from its top left.
struct PixelRectangle {
  int x = 0, y = 0;
  int width = 0, height = 0;

  bool operator==(const PixelRectangle&) const = default;
};

}  // namespace rocinante
