#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/cell/cell.h"
#include "viewer/view/inset_layout.h"

namespace rocinante {

/// An inset that a window may show.
struct WantedInset {
  CellInset inset;
  std::uint64_t opened = 0;  ///< grows with each that the user opened: the latest yields last
};

/// The insets of a window's picture: those that fit, of a size with which no two overlap, and the
/// tabs that are left of the others.
struct InsetColumns {
  std::vector<CellInset> insets;   ///< a smaller one has its size in interface units
  std::vector<std::size_t> shown;  ///< their numbers among those that were wanted, ascending
  struct Tab {
    std::size_t number = 0;  ///< among those that were wanted
    PixelRectangle place;
  };
  std::vector<Tab> tabs;
};

/// No smaller than this, in interface units, unless the cell asks for it: else it folds to a tab.
constexpr int kLeastInsetWidth = 96;
constexpr int kLeastInsetHeight = 64;
constexpr int kInsetTabHeight = 22;

/// Those of a picture of that size in pixels, `scale` of them to an interface unit. The insets of
/// both corners of a side are a column. A column is at most half as wide as the picture when there
/// are two, and as high as the picture; what is larger becomes smaller with its shape kept, all of
/// a column by the same factor; one that would become smaller than the least size folds, the last
/// and longest unopened first. Pure.
InsetColumns fitInsets(const std::vector<WantedInset>& wanted, int width, int height, double scale);

}  // namespace rocinante
