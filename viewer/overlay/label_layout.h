#pragma once

#include <optional>
#include <vector>

#include "viewer/overlay/text_atlas.h"

namespace rocinante {

/// Whole pixels, top left inside, bottom right outside.
struct ScreenBox {
  int left = 0, top = 0, right = 0, bottom = 0;
  bool overlaps(const ScreenBox& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
  bool operator==(const ScreenBox&) const = default;
};

struct LabelAnchor {
  double x = 0, y = 0;  ///< pixels from the top left
  TextSize text;
};

/// Where the plate of each label goes so that none covers another, one of `taken`, or the
/// picture's edge: beside its anchor, else a little farther off; empty when it finds no place. The
/// earlier in the list the better the place. Pure; takes time in proportion to the number of
/// labels.
std::vector<std::optional<ScreenBox>> layOutLabels(const std::vector<LabelAnchor>& anchors,
                                                   const std::vector<ScreenBox>& taken, int width,
                                                   int height);

}  // namespace rocinante
