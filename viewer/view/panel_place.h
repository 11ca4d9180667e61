#pragma once

namespace rocinante {

/// Where the user put a panel, in interface units (pixels at scale 1): its distance from the nearer
/// edges of the window, so that it stays beside them when the window grows.
struct PanelPlace {
  float across = 0, down = 0;
  bool from_right = false, from_bottom = false;
  bool moved = false;  ///< else it lies where it always does
  float width = 0;     ///< 0: its own
  bool collapsed = false;
  bool operator==(const PanelPlace&) const = default;
};

}  // namespace rocinante
