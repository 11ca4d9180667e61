#pragma once

#include <string>

#include "viewer/ui/model/panel_places.h"

namespace rocinante {

/// The panels that stand at an edge of the window; `left` and `right` beside the picture, `bottom`
/// (plots and time line) below all of them.
enum class DockEdge { left, right, bottom };

/// The name under which PanelPlaces keeps an edge's width and whether it is folded.
const char* nameOf(DockEdge edge);

/// What asks for room in a window, in interface units (pixels at scale 1).
struct DockWish {
  struct Side {
    float width = 0;      ///< 0: no panel stands there
    bool folded = false;  ///< by the user: only its strip is there
  };
  Side left, right;
  float time = 0;  ///< height of the time line; 0: there is none
  bool time_folded = false;
  float plots = 0;  ///< wanted height; 0: none
  bool plots_folded = false;
  /// The edge, or kPlotsPeek, that is looked at although it is folded; empty: none.
  std::string peeked{};
};

/// A side of the window: its panel, or the strip that is left of it.
struct DockedSide {
  PanelRectangle panel;   ///< no width: it is folded, or nothing stands there
  PanelRectangle gutter;  ///< at its inner edge, by which it is made wider
  PanelRectangle strip;   ///< no width: it is not folded
  bool peeked = false;    ///< the panel lies over the picture
};

/// Where everything stands in a window; nothing overlaps but what is peeked at.
struct DockLayout {
  DockedSide left, right;
  PanelRectangle time, time_strip;
  PanelRectangle plots, plots_strip;  ///< the strip: they are folded, or have no room
  PanelRectangle picture;
};

/// DockWish::peeked of the plots.
constexpr const char* kPlotsPeek = "plots";

constexpr float kDockStrip = 22;
constexpr float kDockGutter = 7;
constexpr float kLeastPictureWidth = 260;
constexpr float kLeastPictureHeight = 100;
constexpr float kLeastLeftWidth = 298;
constexpr float kLeastRightWidth = 220;
constexpr float kLeastPlotsHeight = 90;

/// The layout of a window of that size, in interface units. What yields to the picture in a small
/// window, in this order: the sides become narrower, down to their least widths; the right folds to
/// its strip; the left does; plots become lower, then fold; the time line folds. The picture keeps
/// 38 % of the width, and the least sizes above while the window has them. Pure.
DockLayout dockLayout(const DockWish& wish, float width, float height);

/// Whether what is peeked at stands in a window of that size without that, or is not there at all.
/// True when nothing is peeked at. Pure.
bool isPeekNeedless(DockWish wish, float width, float height);

/// Folds an edge. One that is only peeked at is left as the user had it: folded, or without room.
void closeEdge(PanelPlaces& places, DockEdge edge);

}  // namespace rocinante
