#pragma once

#include <functional>

#include "viewer/picture/picture.h"

namespace rocinante {

/// A part of a picture: [left, right) x [top, bottom), origin top left.
struct PixelBlock {
  int left = 0, top = 0, right = 0, bottom = 0;

  int width() const { return right - left; }
  int height() const { return bottom - top; }
};

/// Calls `visit`, row by row, for the blocks of `area` where the pictures differ within `reach`
/// pixels of the block. A metric with a window of at most `reach` is zero (or one) in all other
/// blocks and need not be computed there. The pictures must have one shape.
void forEachChangedBlock(const Picture& a, const Picture& b, const PixelBlock& area, int reach,
                         const std::function<void(const PixelBlock&)>& visit);

}  // namespace rocinante
