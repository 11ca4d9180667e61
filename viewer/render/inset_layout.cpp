#include "viewer/render/inset_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace rocinante {
namespace {

constexpr int kLeastSidePx = 16;

/// A side in pixels. A hair is added before the rest is cut off: 0.3 of 640 is 192, and not 191.
int sideOf(double given, bool in_pixels, int picture) {
  const double side = in_pixels ? given : given * picture + 1e-6;
  return static_cast<int>(std::floor(std::clamp(side, 0.0, 65536.0)));
}

}  // namespace

std::vector<PixelRectangle> placeInsets(const std::vector<CellInset>& insets, int width,
                                        int height) {
  std::array<int, 4> used{};  // by corner: pixels from the upper or lower edge that are taken
  std::vector<PixelRectangle> placed;
  for (const CellInset& inset : insets) {
    int& taken = used[static_cast<std::size_t>(inset.corner)];
    PixelRectangle part;
    part.width = std::min(sideOf(inset.width, inset.in_pixels, width), width - 2 * inset.margin_px);
    part.height = std::min(sideOf(inset.height, inset.in_pixels, height),
                           height - taken - 2 * inset.margin_px);
    if (part.width < kLeastSidePx || part.height < kLeastSidePx) {
      placed.emplace_back();
      continue;
    }
    const bool left =
        inset.corner == InsetCorner::top_left || inset.corner == InsetCorner::bottom_left;
    const bool top =
        inset.corner == InsetCorner::top_left || inset.corner == InsetCorner::top_right;
    const int from_edge = taken + inset.margin_px;
    part.x = left ? inset.margin_px : width - inset.margin_px - part.width;
    part.y = top ? from_edge : height - from_edge - part.height;
    taken = from_edge + part.height;
    placed.push_back(part);
  }
  return placed;
}

Result<CellInset> parseInset(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, InsetCorner>, 4> kCorners{
      {{":top-right", InsetCorner::top_right},
       {":top-left", InsetCorner::top_left},
       {":bottom-right", InsetCorner::bottom_right},
       {":bottom-left", InsetCorner::bottom_left}}};
  CellInset inset;
  std::string_view name = text;
  for (const auto& [ending, corner] : kCorners) {
    if (!text.ends_with(ending)) continue;
    name.remove_suffix(ending.size());
    inset.corner = corner;
  }
  if (name.empty()) {
    return Error{
        ErrorKind::bad_argument,
        "`" + std::string(text) + "` is no inset: CAMERA or CAMERA:CORNER, as map:top-left",
        {}};
  }
  inset.camera = name;
  return inset;
}

}  // namespace rocinante
