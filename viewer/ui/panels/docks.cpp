#include "viewer/ui/panels/docks.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"

namespace rocinante {
namespace {

/// A window of the size of its content's place alone, without anything of its own.
constexpr ImGuiWindowFlags kBareFlags =
    ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse |
    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
    ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav;

ImVec2 cornerOf(const PanelRectangle& place) { return {place.x, place.y}; }
ImVec2 farCornerOf(const PanelRectangle& place) {
  return {place.x + place.width, place.y + place.height};
}

PanelRectangle scaled(const PanelRectangle& place, float unit) {
  // On whole pixels: the picture begins there.
  const float left = std::floor(place.x * unit), top = std::floor(place.y * unit);
  return {left, top, std::floor((place.x + place.width) * unit) - left,
          std::floor((place.y + place.height) * unit) - top};
}

DockedSide scaled(const DockedSide& side, float unit) {
  return {scaled(side.panel, unit), scaled(side.gutter, unit), scaled(side.strip, unit),
          side.peeked};
}

DockWish::Side sideWish(const PanelPlaces& places, DockEdge edge, float usual, bool any) {
  const PanelPlace* const place = places.find(nameOf(edge));
  if (!any) return {};
  DockWish::Side side{usual, false};
  if (place == nullptr) return side;
  if (place->width > 0) side.width = place->width;
  side.folded = place->collapsed;
  return side;
}

bool isFolded(const PanelPlaces& places, DockEdge edge) {
  const PanelPlace* const place = places.find(nameOf(edge));
  return place != nullptr && place->collapsed;
}

/// Draws a window that is one button there; its state is that of the last item.
template <class Draw>
void drawBareButton(const char* name, const PanelRectangle& place, const Draw& draw,
                    ImGuiWindowFlags flags = kBareFlags) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  ImGui::SetNextWindowPos(cornerOf(place));
  ImGui::SetNextWindowSize({place.width, place.height});
  ImGui::Begin(name, nullptr, flags);
  ImGui::PopStyleVar(2);
  const bool pressed = ImGui::InvisibleButton("place", {place.width, place.height});
  draw(*ImGui::GetWindowDrawList(), pressed);
  ImGui::End();
}

/// Draws a line of text from `at` downwards, turned by a right angle.
void addTurnedText(ImDrawList& list, ImVec2 at, ImU32 color, const char* text) {
  const int first = list.VtxBuffer.Size;
  // Before it is turned it would lie outside, perhaps of the window itself.
  constexpr float kOutside = 1e5F;
  list.PushClipRect({-kOutside, -kOutside}, {kOutside, kOutside});
  list.AddText(at, color, text);
  list.PopClipRect();
  for (int i = first; i < list.VtxBuffer.Size; ++i) {
    ImVec2& corner = list.VtxBuffer[i].pos;
    corner = {at.x - (corner.y - at.y), at.y + (corner.x - at.x)};
  }
}

/// What points to where a click moves the edge.
void addArrow(ImDrawList& list, ImVec2 middle, ImVec2 towards, ImU32 color) {
  const float size = px(5);
  const ImVec2 across(-towards.y, towards.x);
  list.AddTriangleFilled({middle.x + towards.x * size * 0.6F, middle.y + towards.y * size * 0.6F},
                         {middle.x - towards.x * size * 0.6F + across.x * size,
                          middle.y - towards.y * size * 0.6F + across.y * size},
                         {middle.x - towards.x * size * 0.6F - across.x * size,
                          middle.y - towards.y * size * 0.6F - across.y * size},
                         color);
}

void drawStrip(PanelPlaces& places, DockEdge edge, const DockedSide& side, const char* title) {
  if (side.strip.width <= 0) return;
  // Not its title: the panel that is looked at has that.
  const std::string name = std::string(nameOf(edge)) + " strip";
  drawBareButton(name.c_str(), side.strip, [&](ImDrawList& list, bool pressed) {
    if (pressed && side.peeked) {
      closeEdge(places, edge);
    } else if (pressed) {
      places.openEdge(nameOf(edge));
    }
    const bool hovered = ImGui::IsItemHovered();
    if (hovered)
      list.AddRectFilled(cornerOf(side.strip), farCornerOf(side.strip),
                         panelColor(PanelColor::row_hovered));
    const float inwards = edge == DockEdge::left ? 1.0F : -1.0F;
    const float middle = side.strip.x + side.strip.width / 2;
    addArrow(list, {middle, side.strip.y + px(14)}, {side.peeked ? -inwards : inwards, 0},
             panelColor(hovered ? PanelColor::text : PanelColor::dim_text));
    addTurnedText(list, {middle + ImGui::GetFontSize() / 2, side.strip.y + px(28)},
                  panelColor(hovered ? PanelColor::text : PanelColor::dim_text), title);
    explain(side.peeked ? "a click closes it" : "a click opens it");
  });
}

/// What is looked at lies over the picture, which the mouse does not reach through it, also where
/// no panel stands. Stays below the panels when it is clicked.
void coverPicture(DockEdge edge, const DockedSide& side) {
  if (!side.peeked) return;
  const std::string name = std::string(nameOf(edge)) + " ground";
  drawBareButton(
      name.c_str(), side.panel, [](ImDrawList&, bool) {},
      kBareFlags | ImGuiWindowFlags_NoBringToFrontOnFocus);
}

void drawGutter(PanelPlaces& places, DockEdge edge, const DockedSide& side) {
  if (side.gutter.width <= 0) return;
  const std::string name = std::string(nameOf(edge)) + " gutter";
  drawBareButton(name.c_str(), side.gutter, [&](ImDrawList& list, bool) {
    const bool used = ImGui::IsItemActive() || ImGui::IsItemHovered();
    const ImVec2 middle(side.gutter.x + side.gutter.width / 2,
                        side.gutter.y + side.gutter.height / 2);
    const bool over_handle = std::abs(ImGui::GetIO().MousePos.y - middle.y) < px(18);
    const float outwards = edge == DockEdge::left ? -1.0F : 1.0F;
    list.AddRectFilled(cornerOf(side.gutter), farCornerOf(side.gutter),
                       panelColor(used ? PanelColor::row_hovered : PanelColor::panel));
    addArrow(list, middle, {outwards, 0},
             panelColor(used && over_handle ? PanelColor::text : PanelColor::dim_text));
    const ImGuiIO& io = ImGui::GetIO();
    const bool dragged = io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] >= px(4) * px(4);
    const bool folds = ImGui::IsItemHovered() &&
                       (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) ||
                        (ImGui::IsMouseReleased(ImGuiMouseButton_Left) && !dragged && over_handle));
    if (folds) {
      closeEdge(places, edge);
    } else if (ImGui::IsItemActive() && dragged) {
      const float wide = edge == DockEdge::left ? io.MousePos.x - side.panel.x
                                                : side.panel.x + side.panel.width - io.MousePos.x;
      const float least = edge == DockEdge::left ? kLeastLeftWidth : kLeastRightWidth;
      places.places[nameOf(edge)].width = std::max(least, wide / px(1));
    }
    if (!used) return;
    if (!over_handle) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    explain(over_handle ? "fold these panels to the edge" : "drag: wider or narrower");
  });
}

/// What is left of the plots or the time line; returns whether it was clicked. `opens`: there is
/// room for it, at least at the picture's cost.
bool drawBand(const char* title, const PanelRectangle& band, bool opens) {
  if (band.height <= 0) return false;
  bool clicked = false;
  drawBareButton(title, band, [&](ImDrawList& list, bool pressed) {
    clicked = pressed;
    const bool hovered = ImGui::IsItemHovered();
    if (hovered)
      list.AddRectFilled(cornerOf(band), farCornerOf(band), panelColor(PanelColor::row_hovered));
    const float middle = band.y + band.height / 2;
    addArrow(list, {band.x + px(14), middle}, {0, -1},
             panelColor(hovered ? PanelColor::text : PanelColor::dim_text));
    list.AddText({band.x + px(28), middle - ImGui::GetFontSize() / 2},
                 panelColor(hovered ? PanelColor::text : PanelColor::dim_text), title);
    explain(opens ? "a click opens it" : "there is no room for it: make the window higher");
  });
  return clicked && opens;
}

/// Opaque: text stands on it whatever the picture shows.
void drawBehind(const PanelRectangle& place) {
  if (place.width <= 0 || place.height <= 0) return;
  ImDrawList* const list = ImGui::GetBackgroundDrawList();
  list->AddRectFilled(cornerOf(place), farCornerOf(place), panelColor(PanelColor::panel));
}

DockWish wishOf(const ViewModel& model) {
  DockWish wish;
  const PanelState& panels = model.viewer.panels;
  if (!panels.shown || model.viewer.is_empty) return wish;
  const PanelPlaces& places = panels.places;
  const bool right = !isFloating(places, "figures") || !isFloating(places, "device");
  wish.left = sideWish(places, DockEdge::left, scenePanelWidth(model.isLive()),
                       !isFloating(places, "Scene"));
  wish.right = sideWish(places, DockEdge::right, kDevicePanelWidth, right);
  wish.peeked = places.peeked;
  wish.time = model.cursor() != nullptr ? kTimeBarHeight : 0;
  wish.time_folded = isFolded(places, DockEdge::bottom);
  const PlotBoard& plots = model.viewer.plots;
  wish.plots = (!plots.curves().empty() || !plots.paths().empty()) && model.session() != nullptr
                   ? plots.height
                   : 0;
  wish.plots_folded = plots.hidden;
  return wish;
}

std::set<std::string> stripsOf(const DockLayout& layout) {
  std::set<std::string> strips;
  if (layout.left.strip.width > 0) strips.insert(nameOf(DockEdge::left));
  if (layout.right.strip.width > 0) strips.insert(nameOf(DockEdge::right));
  if (layout.time_strip.height > 0) strips.insert(nameOf(DockEdge::bottom));
  return strips;
}

/// Whether that band would be there if it was looked at.
bool wouldOpen(const ViewModel& model, PanelRectangle DockLayout::*band, const char* peeked) {
  DockWish wish = wishOf(model);
  wish.peeked = peeked;
  wish.plots_folded = false;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  return (dockLayout(wish, size.x / px(1), size.y / px(1)).*band).height > 0;
}

}  // namespace

bool isFloating(const PanelPlaces& places, const char* panel) {
  const PanelPlace* const place = places.find(panel);
  return place != nullptr && place->moved;
}

DockLayout dockLayoutOf(const ViewModel& model, float width, float height, float unit) {
  const DockWish wish = wishOf(model);
  const DockLayout units = dockLayout(wish, width / unit, height / unit);
  return {scaled(units.left, unit),   scaled(units.right, unit),
          scaled(units.time, unit),   scaled(units.time_strip, unit),
          scaled(units.plots, unit),  scaled(units.plots_strip, unit),
          scaled(units.picture, unit)};
}

void endNeedlessPeek(ViewModel& model, float width, float height, float unit) {
  PanelState& panels = model.viewer.panels;
  if (!panels.shown || model.viewer.is_empty) return;
  if (isPeekNeedless(wishOf(model), width / unit, height / unit)) panels.places.peeked.clear();
}

PixelRectangle picturePart(const DockLayout& layout) {
  const PanelRectangle& part = layout.picture;
  return {static_cast<int>(part.x), static_cast<int>(part.y),
          std::max(1, static_cast<int>(part.width)), std::max(1, static_cast<int>(part.height))};
}

void drawDocks(ViewModel& model, const DockLayout& layout) {
  PanelPlaces& places = model.viewer.panels.places;
  places.strips = stripsOf(layout);
  for (const DockedSide* const side : {&layout.left, &layout.right}) {
    drawBehind(side->strip);
    drawBehind(side->panel);
    drawBehind(side->gutter);
  }
  for (const PanelRectangle& band :
       {layout.time, layout.time_strip, layout.plots, layout.plots_strip}) {
    drawBehind(band);
  }
  coverPicture(DockEdge::left, layout.left);
  coverPicture(DockEdge::right, layout.right);
  drawStrip(places, DockEdge::left, layout.left, "Scene");
  drawStrip(places, DockEdge::right, layout.right, "Selection");
  drawGutter(places, DockEdge::left, layout.left);
  drawGutter(places, DockEdge::right, layout.right);
  if (drawBand("Plots", layout.plots_strip, wouldOpen(model, &DockLayout::plots, kPlotsPeek))) {
    model.viewer.plots.hidden = false;
    places.peeked = kPlotsPeek;
  }
  const char* const bottom = nameOf(DockEdge::bottom);
  if (drawBand("Time", layout.time_strip, wouldOpen(model, &DockLayout::time, bottom))) {
    places.openEdge(nameOf(DockEdge::bottom));
  }
}

}  // namespace rocinante
