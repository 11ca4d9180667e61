#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "viewer/picture/picture.h"
#include "viewer/render/text_atlas.h"

namespace rocinante {

struct SheetFrame {
  Picture picture;
  std::string caption;  ///< one line, under the picture
};

/// All frames on one picture, in order, left to right and top to bottom, in about as many columns
/// as rows. The frames are of one size. bad_argument when the sheet would pass 2^27 pixels.
Result<Picture> contactSheet(const std::vector<SheetFrame>& frames, const TextAtlas& atlas);

}  // namespace rocinante
