#pragma once

#include <algorithm>

namespace rocinante {

/// Part of a picture, in pixels from its top left.
struct PixelRectangle {
  int x = 0, y = 0;
  int width = 0, height = 0;

  bool operator==(const PixelRectangle&) const = default;
};

/// What lies in both; empty (width and height 0) where they do not overlap.
inline PixelRectangle overlapOf(const PixelRectangle& a, const PixelRectangle& b) {
  const int left = std::max(a.x, b.x);
  const int top = std::max(a.y, b.y);
  const int right = std::min(a.x + a.width, b.x + b.width);
  const int bottom = std::min(a.y + a.height, b.y + b.height);
  if (right <= left || bottom <= top) return {left, top, 0, 0};
  return {left, top, right - left, bottom - top};
}

}  // namespace rocinante
