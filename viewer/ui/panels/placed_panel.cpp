#include "viewer/ui/panels/placed_panel.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "viewer/ui/panels/panel_parts.h"

namespace rocinante {
namespace {

constexpr float kEdgeReach = 6;
constexpr float kSnapReach = 12;
constexpr float kLeastWidth = 160;
/// A press that moves less is a click.
constexpr float kGrabReach = 4;

/// The edge that can be dragged: the one towards the middle of the window.
bool widensAtRight(const PanelRectangle& panel) {
  return panel.x + panel.width / 2 < ImGui::GetIO().DisplaySize.x / 2;
}

bool isAtEdge(const PanelRectangle& panel, float mouse_x) {
  const float edge = widensAtRight(panel) ? panel.x + panel.width : panel.x;
  return std::abs(mouse_x - edge) <= px(kEdgeReach);
}

}  // namespace

void drawCollapsed(const char* title) {
  ImGui::TextDisabled("%s ...", title);
  explain("a double click opens this panel");
}

PlacedPanel::PlacedPanel(PanelPlaces& places, const char* name, ImVec2 usual, ImVec2 pivot,
                         float width, float tallest)
    : places_(places), name_(name) {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float unit = px(1);
  const PanelPlace* const place = places.find(name_);
  if (place != nullptr && place->width > 0) {
    width = std::min(std::max(place->width * unit, px(kLeastWidth)), window.x);
  }
  moved_ = place != nullptr && place->moved;
  collapsed_ = place != nullptr && place->collapsed;
  if (moved_) {
    const auto drawn = places.drawn.find(name_);
    const float height = drawn == places.drawn.end() ? 0 : drawn->second.height;
    const float known_width =
        width > 0 || drawn == places.drawn.end() ? width : drawn->second.width;
    const PanelRectangle at =
        rectangleOf(*place, known_width / unit, height / unit, window.x / unit, window.y / unit);
    ImGui::SetNextWindowPos(ImVec2(at.x * unit, at.y * unit));
  } else {
    ImGui::SetNextWindowPos(usual, ImGuiCond_Always, pivot);
  }
  if (width > 0) {
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0), ImVec2(width, tallest));
  }
}

void PlacedPanel::grab(const PanelRectangle& now) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  places_.grabbed = name_;
  places_.grabbed_edge = isAtEdge(now, mouse.x);
  places_.grab_x = mouse.x - now.x;
  places_.grab_y = mouse.y - now.y;
  if (places_.grabbed_edge && widensAtRight(now)) places_.grab_x = mouse.x - now.x - now.width;
}

void PlacedPanel::move(PanelRectangle now) {
  const ImGuiIO& io = ImGui::GetIO();
  const float unit = px(1);
  const auto in_units = [unit](const PanelRectangle& one) {
    return PanelRectangle{one.x / unit, one.y / unit, one.width / unit, one.height / unit};
  };
  PanelPlace& place = places_.places[name_];
  if (places_.grabbed_edge) {
    const float at = io.MousePos.x - places_.grab_x;
    const float wide = widensAtRight(now) ? at - now.x : now.x + now.width - at;
    place.width = std::max(wide, px(kLeastWidth)) / unit;
    return;
  }
  now.x = io.MousePos.x - places_.grab_x;
  now.y = io.MousePos.y - places_.grab_y;
  std::vector<PanelRectangle> others;
  for (const auto& [name, other] : places_.drawn) {
    if (name != name_) others.push_back(in_units(other));
  }
  const float across = io.DisplaySize.x / unit;
  const float down = io.DisplaySize.y / unit;
  const PanelRectangle there =
      snapped(in_units(now), others, across, down, kPanelMargin, kSnapReach);
  const PanelPlace before = place;
  place = placeOf(there, across, down);
  place.width = before.width;
  place.collapsed = before.collapsed;
}

void PlacedPanel::follow() {
  const ImVec2 corner = ImGui::GetWindowPos();
  const ImVec2 size = ImGui::GetWindowSize();
  const PanelRectangle now{corner.x, corner.y, size.x, size.y};
  places_.drawn[name_] = now;
  const bool background =
      ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows) && !ImGui::IsAnyItemHovered();
  const bool grabbed = places_.grabbed == name_;
  if ((background && isAtEdge(now, ImGui::GetIO().MousePos.x) && places_.grabbed.empty()) ||
      (grabbed && places_.grabbed_edge)) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  }
  if (background && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    places_.places[name_].collapsed = !collapsed_;
    places_.grabbed.clear();
  } else if (background && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    grab(now);
  } else if (grabbed && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    places_.grabbed.clear();
  } else if (grabbed && ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] >=
                            kGrabReach * kGrabReach) {
    move(now);
  }
}

}  // namespace rocinante
