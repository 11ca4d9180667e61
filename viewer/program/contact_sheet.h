#pragma once

#include <string>

#include "core/base/result.h"
#include "viewer/overlay/text_atlas.h"
#include "viewer/picture/picture.h"

namespace rocinante {

/// The scale of a sheet's tiles of that size for a requested `scale`: text, plates and lines take
/// the same share of a tile as of a 640x480 picture, but at least half their size there
/// (FrameRequest::scale). Pure.
double tileScale(int width, int height, double scale);

/// Many frames of one size on one picture, left to right and top to bottom, in about as many
/// columns as rows, with a line of text under each, cut if wider than the frame.
class ContactSheet {
 public:
  /// bad_argument when the sheet would exceed 2^27 pixels or has no frame. Borrows the atlas.
  static Result<ContactSheet> create(std::size_t frames, int width, int height,
                                     const TextAtlas& atlas);

  /// Puts the frame at `place`, from 0; in any order.
  void put(std::size_t place, const Picture& frame, const std::string& caption);

  const Picture& picture() const { return sheet_; }

 private:
  explicit ContactSheet(const TextAtlas& atlas) : atlas_(&atlas) {}

  const TextAtlas* atlas_;
  Picture sheet_;
  int frame_width_ = 0, frame_height_ = 0;
  int columns_ = 1;
};

}  // namespace rocinante
