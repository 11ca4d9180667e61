#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "viewer/view/panel_place.h"

namespace rocinante {

/// A panel on the window, from its top left.
struct PanelRectangle {
  float x = 0, y = 0, width = 0, height = 0;
  bool operator==(const PanelRectangle&) const = default;
};

/// Where the user put panels, by their names (an edge's name has its width, and whether it is
/// folded), and the panel that is being moved.
struct PanelPlaces {
  std::map<std::string, PanelPlace> places;
  std::map<std::string, PanelRectangle> drawn;  ///< of the last frame, in pixels
  std::string grabbed;                          ///< empty: none
  bool grabbed_edge = false;                    ///< its width is changed, not its place
  float grab_x = 0, grab_y = 0;                 ///< of the pointer in the panel
  std::set<std::string> strips;  ///< edges that the last frame had as strips, looked at or not
  std::string peeked;   ///< a folded edge whose panels are looked at over the picture; empty: none
  std::string pressed;  ///< on whose background the left button last went down; empty: none
  std::string pressed_before;  ///< the same of the press before that

  /// Null when the panel lies where it always does, at its own width, and is open.
  const PanelPlace* find(const std::string& panel) const;
  /// A folded edge is opened where there is room, else looked at over the picture.
  void openEdge(const std::string& edge) {
    const auto place = places.find(edge);
    if (place != places.end()) place->second.collapsed = false;
    peeked = edge;
  }
};

/// `moving`, with an edge that is within `reach` of the window's margin or of another panel put
/// exactly there (beside another one with `margin` between), and inside the window. Pure.
PanelRectangle snapped(PanelRectangle moving, std::span<const PanelRectangle> others,
                       float window_width, float window_height, float margin, float reach);

/// The place of a panel that lies there, for a window of that size; all in interface units. Pure.
PanelPlace placeOf(const PanelRectangle& panel, float window_width, float window_height);

/// Left and top of a panel of that size at the place, inside the window if it fits. Pure.
PanelRectangle rectangleOf(const PanelPlace& place, float width, float height, float window_width,
                           float window_height);

}  // namespace rocinante
