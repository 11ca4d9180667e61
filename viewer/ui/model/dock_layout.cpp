#include "viewer/ui/model/dock_layout.h"

#include <algorithm>
#include <array>
#include <utility>

namespace rocinante {
namespace {

/// The widths of both sides, gutters included; 0: folded, or nothing stands there.
struct Widths {
  float left = 0, right = 0;
};

float widthOf(const DockWish::Side& side) {
  return side.width > 0 && !side.folded ? side.width + kDockGutter : 0;
}

float stripOf(const DockWish::Side& side, float width) {
  return side.width > 0 && width == 0 ? kDockStrip : 0;
}

Widths sideWidths(const DockWish& wish, float width) {
  const float picture = std::max(kLeastPictureWidth, 0.38F * width);
  Widths sides{widthOf(wish.left), widthOf(wish.right)};
  const auto missing = [&] {
    return sides.left + sides.right + stripOf(wish.left, sides.left) +
           stripOf(wish.right, sides.right) + picture - width;
  };
  const float left_slack = std::max(0.0F, sides.left - kLeastLeftWidth - kDockGutter);
  const float right_slack = std::max(0.0F, sides.right - kLeastRightWidth - kDockGutter);
  if (missing() > 0 && left_slack + right_slack > 0) {
    const float part = std::min(1.0F, missing() / (left_slack + right_slack));
    sides.left -= part * left_slack;
    sides.right -= part * right_slack;
  }
  // By less than a unit it is a matter of rounding.
  if (missing() > 0.5F) {
    sides.right = 0;
    sides.left = widthOf(wish.left);
    sides.left -= std::clamp(missing(), 0.0F, left_slack);
  }
  if (missing() > 0.5F) sides.left = 0;
  return sides;
}

/// The side at `x`, `width` wide, of a middle that reaches from `top` down to `bottom`.
DockedSide placeSide(const DockWish::Side& wish, float width, bool at_left, bool peeked,
                     float window_width, float bottom) {
  DockedSide side;
  if (wish.width <= 0) return side;
  const auto across = [&](float from_edge, float wide) {
    return PanelRectangle{at_left ? from_edge : window_width - from_edge - wide, 0, wide, bottom};
  };
  float from_edge = 0;
  if (width == 0) {
    side.strip = across(0, kDockStrip);
    side.peeked = peeked;
    if (!peeked) return side;
    from_edge = kDockStrip;
    width = std::min(wish.width, window_width - kDockStrip - kDockGutter) + kDockGutter;
  }
  side.panel = across(from_edge, width - kDockGutter);
  side.gutter = across(from_edge + width - kDockGutter, kDockGutter);
  return side;
}

/// Takes a band off the lower end of what is left.
PanelRectangle takeBand(float height, float width, float& bottom) {
  bottom -= height;
  return {0, bottom, width, height};
}

}  // namespace

const char* nameOf(DockEdge edge) {
  constexpr std::array<const char*, 3> kNames{"left", "right", "bottom"};
  return kNames[static_cast<std::size_t>(edge)];
}

DockLayout dockLayout(const DockWish& wish, float width, float height) {
  DockLayout layout;
  float bottom = height;
  if (wish.time > 0) {
    const bool peeked = wish.peeked == nameOf(DockEdge::bottom);
    // Who looks at it takes it from the picture, but for a strip, and one of the plots.
    const float strips = wish.plots > 0 ? 2 * kDockStrip : kDockStrip;
    const float least = peeked ? strips : kLeastPictureHeight;
    const bool folded = (wish.time_folded && !peeked) || height - wish.time < least;
    if (folded) {
      layout.time_strip = takeBand(std::min(kDockStrip, height), width, bottom);
    } else {
      layout.time = takeBand(wish.time, width, bottom);
    }
  }
  if (wish.plots > 0) {
    const bool peeked = wish.peeked == kPlotsPeek;
    const float least = peeked ? kDockStrip : kLeastPictureHeight;
    const float most = peeked ? std::max(0.6F * height, kLeastPlotsHeight) : 0.6F * height;
    const float room = std::min(most, bottom - least);
    if (wish.plots_folded || room < kLeastPlotsHeight) {
      layout.plots_strip = takeBand(std::min(kDockStrip, bottom), width, bottom);
    } else {
      layout.plots = takeBand(std::clamp(wish.plots, kLeastPlotsHeight, room), width, bottom);
    }
  }
  const Widths sides = sideWidths(wish, width);
  layout.left =
      placeSide(wish.left, sides.left, true, wish.peeked == nameOf(DockEdge::left), width, bottom);
  layout.right = placeSide(wish.right, sides.right, false, wish.peeked == nameOf(DockEdge::right),
                           width, bottom);
  const float from = sides.left + layout.left.strip.width;
  const float until = width - sides.right - layout.right.strip.width;
  layout.picture = {from, 0, std::max(1.0F, until - from), std::max(1.0F, bottom)};
  return layout;
}

bool isPeekNeedless(DockWish wish, float width, float height) {
  const std::string peeked = std::exchange(wish.peeked, {});
  const DockLayout layout = dockLayout(wish, width, height);
  if (peeked == nameOf(DockEdge::left)) return layout.left.strip.width <= 0;
  if (peeked == nameOf(DockEdge::right)) return layout.right.strip.width <= 0;
  if (peeked == nameOf(DockEdge::bottom)) return layout.time_strip.height <= 0;
  // Plots that are hidden are not looked at.
  return peeked != kPlotsPeek || wish.plots_folded || layout.plots_strip.height <= 0;
}

void closeEdge(PanelPlaces& places, DockEdge edge) {
  const bool peeked = std::exchange(places.peeked, {}) == nameOf(edge);
  if (!peeked) places.places[nameOf(edge)].collapsed = true;
}

}  // namespace rocinante
