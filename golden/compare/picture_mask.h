#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "viewer/picture/picture.h"

namespace rocinante {

/// Pixels of a picture, from (x, y) to the right and down; origin top left.
struct MaskRectangle {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const MaskRectangle&) const = default;

  /// "X,Y,WIDTHxHEIGHT": what `golden compare --mask` takes.
  static Result<MaskRectangle> parse(std::string_view text);
  std::string text() const;
};

/// Some of the pixels of a picture: width * height values, top row first, 1 for those in the set.
using PixelSet = std::vector<std::uint8_t>;

/// The pixels whose number in `ids` is true in `wanted`, and `margin` pixels around them,
/// diagonally too: multisampling mixes an edge into its neighbours. `ids` has width * height
/// values, top row first.
PixelSet pixelsWithIds(std::span<const std::uint32_t> ids, const std::vector<bool>& wanted,
                       int width, int height, int margin = 1);
/// Adds `more`, of the same size, to `set`.
void unite(PixelSet& set, const PixelSet& more);

/// The pixels of a picture that are not judged, with the number hidden by each mask.
class PictureMask {
 public:
  struct Part {
    std::string name;         ///< as the user wrote it
    std::int64_t pixels = 0;  ///< hidden by it, also if another mask hides them too
  };

  PictureMask(int width, int height);

  /// Hides the part of the rectangle inside the picture.
  void hide(const MaskRectangle& rectangle, std::string name);
  /// Hides a set of width * height pixels.
  void hide(const PixelSet& pixels, std::string name);
  /// Hides everything except a set.
  void hideOthers(PixelSet pixels, std::string name);

  int width() const { return width_; }
  int height() const { return height_; }
  /// In the order in which they were added.
  const std::vector<Part>& parts() const { return parts_; }
  bool hides(int x, int y) const;
  std::int64_t hiddenPixels() const;
  bool hidesEverything() const;

  /// `frame` with the golden's pixels where the mask hides. Both must have the mask's size.
  Picture applied(const Picture& frame, const Picture& golden) const;

 private:
  int width_, height_;
  PixelSet hidden_;
  std::vector<Part> parts_;
};

}  // namespace rocinante
