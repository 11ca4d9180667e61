#include "viewer/ui/panels/view_cube_panel.h"

#include <imgui.h>

#include <array>
#include <cmath>
#include <string>

#include "viewer/ui/model/view_cube.h"
#include "viewer/ui/model/view_insets.h"
#include "viewer/ui/panels/panel_parts.h"

namespace rocinante {
namespace {

constexpr float kSize = 88;      ///< of the square around it
constexpr float kHalfEdge = 24;  ///< a corner comes as far as the square's edge
constexpr float kCubeClickReach = 4;

/// The cube's axes and its middle in the window.
struct ShownCube {
  ViewAxes axes;
  ImVec2 middle;
  float half_edge;

  ImVec2 at(const Vec2& place) const {
    return ImVec2(middle.x + static_cast<float>(place.x) * half_edge,
                  middle.y + static_cast<float>(place.y) * half_edge);
  }
  std::array<ImVec2, 4> corners(const CubePatch& patch) const {
    return {at(patch.corners[0]), at(patch.corners[1]), at(patch.corners[2]), at(patch.corners[3])};
  }
};

ViewAxes axesOf(const CameraView& view) {
  const Camera camera(view, 1, 1, ClipDepth::zero_to_one, 1);
  return {camera.right(), camera.up(), camera.forward()};
}

}  // namespace

std::optional<PixelRectangle> viewCubePlace(ViewModel& model, const PanelRectangle& room) {
  if (!model.viewer.panels.cube_shown) return std::nullopt;
  std::vector<PixelRectangle> insets;
  const PixelRectangle& picture = model.viewer.picture_part;
  const auto add = [&](PixelRectangle part) {
    part.x += picture.x;
    part.y += picture.y;
    insets.push_back(part);
  };
  for (const InsetPlace& inset : model.viewer.inset_places) add(inset.part);
  for (const InsetTab& tab : insetTabs(model, picture.width, picture.height, px(1))) add(tab.place);
  const PixelRectangle whole{static_cast<int>(room.x), static_cast<int>(room.y),
                             static_cast<int>(room.width), static_cast<int>(room.height)};
  return placeViewCube(whole, insets, static_cast<int>(px(kSize)),
                       static_cast<int>(px(kPanelMargin)));
}

namespace {

/// Opaque, and darker the more it is turned away.
ImU32 faceColor(double facing) {
  ImVec4 color = panelInk(PanelColor::field);
  const auto light = 0.72F + 0.28F * static_cast<float>(facing);
  for (float* const part : {&color.x, &color.y, &color.z}) *part *= light;
  return ImGui::ColorConvertFloat4ToU32(color);
}

void drawCube(const ShownCube& cube, const std::optional<ViewSide>& marked) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::vector<CubePatch> faces = visibleFaces(cube.axes);
  for (const CubePatch& face : faces) {
    const auto corners = cube.corners(face);
    list.AddConvexPolyFilled(corners.data(), 4, faceColor(face.facing));
  }
  if (marked) {
    for (const CubePatch& patch : visiblePatches(cube.axes, *marked)) {
      const auto corners = cube.corners(patch);
      list.AddConvexPolyFilled(corners.data(), 4, panelColor(PanelColor::repeated_part));
    }
  }
  for (const CubePatch& face : faces) {
    const auto corners = cube.corners(face);
    list.AddQuad(corners[0], corners[1], corners[2], corners[3], panelColor(PanelColor::dim_text),
                 px(1));
    // A name that does not fit is said when the mouse is there.
    const std::string name = nameOf(face.face);
    const ImVec2 size = ImGui::CalcTextSize(name.c_str());
    const double room = 2 * cube.half_edge * face.facing;
    if (face.facing < 0.8 || static_cast<double>(size.x) > room) continue;
    const Vec2 middle = (face.corners[0] + face.corners[2]) * 0.5;
    const ImVec2 at = cube.at(middle);
    const bool on_marked = marked && *marked == face.face;
    list.AddText(ImVec2(std::floor(at.x - size.x / 2), std::floor(at.y - size.y / 2)),
                 panelColor(on_marked ? PanelColor::repeated_part_text : PanelColor::text),
                 name.c_str());
  }
}

/// A drag turns the view, the wheel zooms, a click looks from `side`.
void useMouse(ViewModel& model, const std::optional<ViewSide>& side) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool dragged = io.MouseDragMaxDistanceSqr[0] >= kCubeClickReach * kCubeClickReach;
  const int height = model.viewer.picture_part.height;
  if (ImGui::IsItemActive() && dragged && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0)) {
    model.holdCamera().orbit(io.MouseDelta.x, io.MouseDelta.y, height);
  }
  if (ImGui::IsItemHovered() && io.MouseWheel != 0) model.holdCamera().zoom(io.MouseWheel);
  if (ImGui::IsItemDeactivated() && !dragged && side) {
    model.holdCamera().lookFrom(directionFrom(*side));
  }
}

}  // namespace

void drawViewCube(ViewModel& model, const PanelRectangle& room) {
  const auto place = viewCubePlace(model, room);
  if (!place) return;
  const ImVec2 low(static_cast<float>(place->x), static_cast<float>(place->y));
  const auto size = static_cast<float>(place->width);
  ImGui::SetNextWindowPos(low);
  ImGui::SetNextWindowSize(ImVec2(size, size));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  // Behind the panels, and before the picture, which the mouse does not reach through it.
  ImGui::Begin("view cube", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollWithMouse);
  const ShownCube cube{axesOf(model.cameraView()), ImVec2(low.x + size / 2, low.y + size / 2),
                       px(kHalfEdge)};
  ImGui::InvisibleButton("sides", ImVec2(size, size));
  std::optional<ViewSide> side;
  if (ImGui::IsItemHovered() || ImGui::IsItemDeactivated()) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto scale = static_cast<double>(cube.half_edge);
    side = cubeSideAt(cube.axes,
                      Vec2((mouse.x - cube.middle.x) / scale, (mouse.y - cube.middle.y) / scale));
  }
  useMouse(model, side);
  drawCube(cube, side);
  if (side && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", nameOf(*side).c_str());
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace rocinante
