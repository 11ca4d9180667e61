#include "viewer/ui/program/gizmo_input.h"

#include <imgui.h>

#include "viewer/ui/model/pose_fields.h"
#include "viewer/ui/window/interface_context.h"

namespace rocinante {

bool applyGizmo(ViewModel& model) {
  if (!model.viewer.gizmo.shown) return false;
  const ImGuiIO& io = ImGui::GetIO();
  const PixelRectangle& part = model.viewer.picture_part;
  const PicturePlaces places(model.cameraView(), part.width, part.height);
  const Vec2 mouse(io.MousePos.x - static_cast<float>(part.x),
                   io.MousePos.y - static_cast<float>(part.y));
  if (model.viewer.gizmo.drag) {
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
      dragGizmo(model, places, mouse, io.KeyShift);
    } else {
      releaseGizmo(model);
    }
    return true;
  }
  if (io.WantCaptureMouse || !ImGui::IsMouseClicked(ImGuiMouseButton_Left) || io.KeyShift) {
    return false;
  }
  takeTypedPose(model);  // the drag begins there
  const double scale = ImGui::GetFontSize() / kFontPixels;
  return grabGizmo(model, places, mouse, kGizmoArrowPx * scale, kGizmoReachPx * scale);
}

}  // namespace rocinante
