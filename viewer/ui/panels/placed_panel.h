#pragma once

#include <imgui.h>

#include <string>

#include "viewer/ui/model/panel_places.h"

namespace rocinante {

/// What is left of a collapsed panel.
void drawCollapsed(const char* title);

/// A panel that the user may move by its background, widen at its inner edge, and collapse by a
/// double click. Lives around one ImGui window, from before Begin() to before End().
class PlacedPanel {
 public:
  /// Where it lies and how wide it is when the user has not said otherwise, in pixels; `pivot` as
  /// in SetNextWindowPos(). Width 0: as its content needs. `tallest`: for it to stay on the window.
  PlacedPanel(PanelPlaces& places, const char* name, ImVec2 usual, ImVec2 pivot, float width,
              float tallest);

  /// Only its name is to be drawn.
  bool collapsed() const { return collapsed_; }
  bool moved() const { return moved_; }
  /// Takes the mouse; after everything in the window.
  void follow();

 private:
  void grab(const PanelRectangle& now);
  void move(PanelRectangle now);

  PanelPlaces& places_;
  std::string name_;
  bool collapsed_ = false, moved_ = false;
};

}  // namespace rocinante
