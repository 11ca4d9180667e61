#include "viewer/ui/panels/placed_panel.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "viewer/ui/panels/docks.h"
#include "viewer/ui/panels/panel_parts.h"

namespace rocinante {
namespace {

constexpr float kEdgeReach = 6;
constexpr float kSnapReach = 12;
constexpr float kLeastWidth = 160;
/// A press that moves less is a click.
constexpr float kGrabReach = 4;
/// So far a docked panel is dragged before it leaves its edge.
constexpr float kLeaveReach = 24;
/// So near the edge of the window a floating panel is dropped onto it.
constexpr float kHomeReach = 16;

/// The edge that can be dragged: the one towards the middle of the window.
bool widensAtRight(const PanelRectangle& panel) {
  return panel.x + panel.width / 2 < ImGui::GetIO().DisplaySize.x / 2;
}

bool isAtEdge(const PanelRectangle& panel, float mouse_x) {
  const float edge = widensAtRight(panel) ? panel.x + panel.width : panel.x;
  return std::abs(mouse_x - edge) <= px(kEdgeReach);
}

float draggedBy() {
  return std::sqrt(ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Left]);
}

}  // namespace

void notePress(PanelPlaces& places) {
  if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return;
  places.pressed_before = std::exchange(places.pressed, {});
}

bool isDoubleClicked(PanelPlaces& places, const std::string& panel, bool on_background) {
  if (!on_background || !ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return false;
  places.pressed = panel;
  return places.pressed_before == panel && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
}

void drawCollapsed(const char* title) {
  ImGui::TextDisabled("%s ...", title);
  explain("a double click opens this panel");
}

PlacedPanel::PlacedPanel(PanelPlaces& places, const char* name, PanelHome home, float usual_width)
    : places_(places), name_(name), home_(home), usual_width_(usual_width) {
  const PanelPlace* const place = places.find(name_);
  moved_ = place != nullptr && place->moved;
  collapsed_ = moved_ && place->collapsed;
}

bool PlacedPanel::begin() {
  if (!moved_ && home_.room.width <= 0) {
    places_.drawn.erase(name_);
    return false;
  }
  if (moved_) {
    placeFloating();
    ImGui::Begin(name_.c_str(), nullptr, kPanelFlags | ImGuiWindowFlags_NoTitleBar);
    return true;
  }
  placeDocked();
  return true;
}

void PlacedPanel::placeFloating() {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float unit = px(1);
  const PanelPlace& place = *places_.find(name_);
  const float width = place.width > 0
                          ? std::min(std::max(place.width * unit, px(kLeastWidth)), window.x)
                          : usual_width_;
  const auto drawn = places_.drawn.find(name_);
  const float height = drawn == places_.drawn.end() ? 0 : drawn->second.height;
  const PanelRectangle at =
      rectangleOf(place, width / unit, height / unit, window.x / unit, window.y / unit);
  bottom_ = window.y - px(kPanelMargin);
  ImGui::SetNextWindowPos({at.x * unit, at.y * unit});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, window.y});
}

void PlacedPanel::placeDocked() {
  const PanelRectangle& room = home_.room;
  bottom_ = room.y + room.height;
  ImGui::SetNextWindowPos({room.x, room.y});
  ImGuiWindowFlags flags = kPanelFlags | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize;
  if (home_.fills) {
    flags &= ~ImGuiWindowFlags_AlwaysAutoResize;
    ImGui::SetNextWindowSize({room.width, room.height});
  } else {
    ImGui::SetNextWindowSizeConstraints({room.width, 0}, {room.width, room.height});
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  ImGui::SetNextWindowBgAlpha(1);
  ImGui::Begin(name_.c_str(), nullptr, flags);
  ImGui::PopStyleVar(2);
}

void PlacedPanel::end() {
  follow();
  ImGui::End();
}

void PlacedPanel::grab(const PanelRectangle& now) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  places_.grabbed = name_;
  places_.grabbed_edge = moved_ && isAtEdge(now, mouse.x);
  places_.grab_x = mouse.x - now.x;
  places_.grab_y = mouse.y - now.y;
  if (places_.grabbed_edge && widensAtRight(now)) places_.grab_x = mouse.x - now.x - now.width;
}

void PlacedPanel::drag(PanelRectangle now) {
  if (!moved_ && draggedBy() < px(kLeaveReach)) return;
  const float unit = px(1);
  if (places_.grabbed_edge) {
    const float at = ImGui::GetIO().MousePos.x - places_.grab_x;
    const float wide = widensAtRight(now) ? at - now.x : now.x + now.width - at;
    places_.places[name_].width = std::max(wide, px(kLeastWidth)) / unit;
    return;
  }
  if (!moved_) {
    // Held as near its corner as a panel of its own size can be.
    places_.grab_x = std::min(places_.grab_x, usual_width_ - px(kEdgeReach));
    now.width = usual_width_;
  }
  move(now);
}

void PlacedPanel::move(PanelRectangle now) {
  const ImGuiIO& io = ImGui::GetIO();
  const float unit = px(1);
  const auto in_units = [unit](const PanelRectangle& one) {
    return PanelRectangle{one.x / unit, one.y / unit, one.width / unit, one.height / unit};
  };
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
  PanelPlace& place = places_.places[name_];
  const PanelPlace before = place;
  place = placeOf(there, across, down);
  place.width = before.width;
  place.collapsed = before.collapsed;
  if (!isOverHome()) return;
  const float edge = home_.edge == DockEdge::left ? 0 : io.DisplaySize.x - px(kHomeReach);
  ImGui::GetForegroundDrawList()->AddRectFilled(
      {edge, 0}, {edge + px(kHomeReach), io.DisplaySize.y}, panelColor(PanelColor::drop_place));
}

bool PlacedPanel::isOverHome() const {
  const ImGuiIO& io = ImGui::GetIO();
  const float from_edge =
      home_.edge == DockEdge::left ? io.MousePos.x : io.DisplaySize.x - io.MousePos.x;
  return from_edge < px(kHomeReach);
}

void PlacedPanel::drop() {
  const bool goes_home =
      moved_ && !places_.grabbed_edge && draggedBy() >= kGrabReach && isOverHome();
  places_.grabbed.clear();
  if (goes_home) places_.places.erase(name_);
}

void PlacedPanel::follow() {
  const ImVec2 corner = ImGui::GetWindowPos();
  const ImVec2 size = ImGui::GetWindowSize();
  const PanelRectangle now{corner.x, corner.y, size.x, size.y};
  places_.drawn[name_] = now;
  const bool background =
      ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows) && !ImGui::IsAnyItemHovered();
  const bool grabbed = places_.grabbed == name_;
  if (moved_ &&
      ((background && isAtEdge(now, ImGui::GetIO().MousePos.x) && places_.grabbed.empty()) ||
       (grabbed && places_.grabbed_edge))) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  }
  if (isDoubleClicked(places_, name_, background)) {
    if (moved_) {
      places_.places[name_].collapsed = !collapsed_;
    } else {
      closeEdge(places_, home_.edge);
    }
    places_.peeked.clear();
    places_.grabbed.clear();
  } else if (background && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    grab(now);
  } else if (grabbed && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    drop();
  } else if (grabbed && draggedBy() >= kGrabReach) {
    drag(now);
  }
}

}  // namespace rocinante
