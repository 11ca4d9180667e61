#pragma once

#include <optional>
#include <vector>

#include "viewer/overlay/text_atlas.h"

namespace rocinante {

/// Whole pixels; top left inclusive, bottom right exclusive.
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

/// Places the plate of each label so that it does not cover another plate, one of `taken` or the
/// picture's edge: beside its anchor, else a little farther away; empty when there is no place.
/// Earlier labels get better places. Pure; linear in the number of labels.
std::vector<std::optional<ScreenBox>> layOutLabels(const std::vector<LabelAnchor>& anchors,
                                                   const std::vector<ScreenBox>& taken, int width,
                                                   int height);

}  // namespace rocinante
