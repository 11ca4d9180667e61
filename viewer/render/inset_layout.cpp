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
int sideOf(double given, bool in_pixels, int picture, double scale) {
  const double side = in_pixels ? given * scale : given * picture + 1e-6;
  return static_cast<int>(std::floor(std::clamp(side, 0.0, 65536.0)));
}

}  // namespace

std::vector<PixelRectangle> placeInsets(const std::vector<CellInset>& insets, int width, int height,
                                        double scale) {
  std::array<int, 4> used{};  // by corner: pixels from the upper or lower edge that are taken
  std::vector<PixelRectangle> placed;
  for (const CellInset& inset : insets) {
    int& taken = used[static_cast<std::size_t>(inset.corner)];
    const int margin = static_cast<int>(std::floor(inset.margin_px * scale + 0.5));
    PixelRectangle part;
    part.width = std::min(sideOf(inset.width, inset.in_pixels, width, scale), width - 2 * margin);
    part.height =
        std::min(sideOf(inset.height, inset.in_pixels, height, scale), height - taken - 2 * margin);
    if (part.width < kLeastSidePx || part.height < kLeastSidePx) {
      placed.emplace_back();
      continue;
    }
    const bool left =
        inset.corner == InsetCorner::top_left || inset.corner == InsetCorner::bottom_left;
    const bool top =
        inset.corner == InsetCorner::top_left || inset.corner == InsetCorner::top_right;
    const int from_edge = taken + margin;
    part.x = left ? margin : width - margin - part.width;
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
