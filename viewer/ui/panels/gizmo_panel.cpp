#include "viewer/ui/panels/gizmo_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <string>
#include <vector>

#include "viewer/ui/model/inspection.h"
#include "viewer/ui/panels/panel_parts.h"

namespace rocinante {
namespace {

using HandleKind = GizmoHandle::Kind;

/// As in the corner of the picture.
constexpr std::array kAxes{PanelColor::axis_x, PanelColor::axis_y, PanelColor::axis_z};

/// `origin`: of the picture, in the window.
void drawHandle(const Gizmo& gizmo, const PicturePlaces& places, ImVec2 origin,
                const GizmoHandle& handle, bool marked) {
  std::vector<ImVec2> corners;
  for (const Vec3& corner : outlineOf(gizmo, handle)) {
    const auto pixel = places.pixelOf(corner);
    if (!pixel) return;
    corners.emplace_back(origin.x + static_cast<float>(pixel->x),
                         origin.y + static_cast<float>(pixel->y));
  }
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImU32 color =
      panelColor(marked ? PanelColor::grip_held : kAxes[static_cast<std::size_t>(handle.axis)]);
  const float width = px(marked ? 3 : 2);
  if (handle.kind == HandleKind::arrow) {
    list.AddLine(corners[0], corners[1], color, width);
    list.AddCircleFilled(corners[1], px(5), color);
    return;
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    list.AddLine(corners[i], corners[(i + 1) % corners.size()], color, width);
  }
}

/// "x 1.250 m, y ..., z ...; roll 0.0, ...": in the units of the panels.
std::string poseText(const ViewModel& model, const Pose& pose) {
  const Units& units = model.hand.units;
  const Vec3 rpy = rpyOf(pose.orientation);
  const Vec3& at = pose.position;
  return fmt::format("x {}  y {}  z {}\nroll {}  pitch {}  yaw {}", lengthText(at.x, units.length),
                     lengthText(at.y, units.length), lengthText(at.z, units.length),
                     angleText(rpy.x, units.angle), angleText(rpy.y, units.angle),
                     angleText(rpy.z, units.angle));
}

}  // namespace

void drawGizmo(ViewModel& model) {
  if (!model.viewer.gizmo.shown) return;
  const PixelRectangle& part = model.viewer.picture_part;
  const ImVec2 origin(static_cast<float>(part.x), static_cast<float>(part.y));
  const PicturePlaces places(model.cameraView(), part.width, part.height);
  const double arrow = static_cast<double>(px(1)) * kGizmoArrowPx;
  const double reach = static_cast<double>(px(1)) * kGizmoReachPx;
  const auto gizmo = gizmoOf(model, places, arrow);
  if (!gizmo) return;
  const ImGuiIO& io = ImGui::GetIO();
  const auto& drag = model.viewer.gizmo.drag;
  std::optional<GizmoHandle> marked;
  if (drag) {
    marked = drag->handle;
  } else if (!io.WantCaptureMouse && ImGui::IsMousePosValid() && !ImGui::IsAnyMouseDown()) {
    marked =
        handleAt(*gizmo, places, Vec2(io.MousePos.x - origin.x, io.MousePos.y - origin.y), reach);
  }
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect(origin, {origin.x + static_cast<float>(part.width),
                             origin.y + static_cast<float>(part.height)});
  for (const HandleKind kind : {HandleKind::ring, HandleKind::square, HandleKind::arrow}) {
    for (int axis = 0; axis < 3; ++axis) {
      const GizmoHandle handle{kind, axis};
      drawHandle(*gizmo, places, origin, handle, marked == handle);
    }
  }
  list.PopClipRect();
  const PosedDevice* const device = model.scene().findDevice(model.selected.device);
  if (!marked || device == nullptr) return;
  ImGui::SetTooltip("%s\n%s", poseText(model, device->pose).c_str(),
                    model.viewer.gizmo.snaps ? "by steps; with Shift freely" : "freely");
}

}  // namespace rocinante
