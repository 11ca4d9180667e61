#pragma once

#include <imgui.h>

#include <string>

#include "viewer/ui/model/dock_layout.h"

namespace rocinante {

/// Keeps on which background the press before this frame's was. Once a frame, before the panels.
void notePress(PanelPlaces& places);

/// Whether this frame has the second press of a double click on the background of the panel, which
/// the first was on, too: not on a button that went away. `on_background`: the mouse is there.
bool isDoubleClicked(PanelPlaces& places, const std::string& panel, bool on_background);

/// What is left of a collapsed panel.
void drawCollapsed(const char* title);

/// Where a panel stands unless the user took it off its edge, in pixels.
struct PanelHome {
  DockEdge edge = DockEdge::left;
  PanelRectangle room;  ///< no width: its edge is folded
  bool fills = true;    ///< takes all of its room, else the height of what it says
};

/// A panel that stands at an edge of the window, or floats where the user dragged it by its
/// background. A double click on that folds its edge, and collapses a floating one; a floating one
/// is widened at its inner edge, and stands at its edge again when it is dropped there.
class PlacedPanel {
 public:
  /// `usual_width`: of a floating one. Between begin() and end() its window is the current one.
  PlacedPanel(PanelPlaces& places, const char* name, PanelHome home, float usual_width);

  /// False: it is nowhere, and there is nothing to end.
  bool begin();
  /// Only its name is to be drawn.
  bool collapsed() const { return collapsed_; }
  bool floating() const { return moved_; }
  /// The lowest pixel that it may use.
  float bottom() const { return bottom_; }
  /// Takes the mouse, too.
  void end();

 private:
  void placeFloating();
  void placeDocked();
  void follow();
  void grab(const PanelRectangle& now);
  void drag(PanelRectangle now);
  void move(PanelRectangle now);
  void drop();
  bool isOverHome() const;

  PanelPlaces& places_;
  std::string name_;
  PanelHome home_;
  float usual_width_;
  float bottom_ = 0;
  bool collapsed_ = false, moved_ = false;
};

}  // namespace rocinante
