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

/// Calls `visit` for the blocks of `area`, row by row, around which the pictures differ: within
/// `reach` pixels of the block. A figure that looks no further is zero (or one) in all the others
/// and need not be computed there. The pictures are of one shape.
void forEachChangedBlock(const Picture& a, const Picture& b, const PixelBlock& area, int reach,
                         const std::function<void(const PixelBlock&)>& visit);

}  // namespace rocinante
