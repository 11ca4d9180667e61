#include "viewer/ui/program/fly_input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include "viewer/ui/window/frame_input.h"

namespace rocinante {
namespace {

FlyKeys heldFlyKeys() {
  FlyKeys keys;
  keys.forward = isKeyHeld(GLFW_KEY_W);
  keys.back = isKeyHeld(GLFW_KEY_S);
  keys.left = isKeyHeld(GLFW_KEY_A);
  keys.right = isKeyHeld(GLFW_KEY_D);
  keys.up = isKeyHeld(GLFW_KEY_E);
  keys.down = isKeyHeld(GLFW_KEY_Q);
  keys.faster = ImGui::GetIO().KeyShift;
  return keys;
}

}  // namespace

bool applyFlying(ViewModel& model, SteadyTime now, int height_px, ViewerRequests& requests) {
  FlyMode& fly = model.viewer.fly;
  const ImGuiIO& io = ImGui::GetIO();
  const bool held = ImGui::IsMouseDown(ImGuiMouseButton_Right) && !io.WantCaptureMouse;
  const bool typing = io.WantTextInput || model.viewer.panels.palette.shown ||
                      model.viewer.panels.open.shown || io.KeyCtrl;
  if (!held || typing) {
    fly.end();
    return false;
  }
  // The coming frames need it.
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Right)) requests.measure_scene = true;
  if (fly.active() && io.MouseWheel != 0) fly.changeSpeed(io.MouseWheel);
  const Vec3 moved = fly.step(heldFlyKeys(), now);
  if (!fly.active()) return false;
  if (moved != Vec3(0, 0, 0)) model.holdCamera().fly(moved.x, moved.y, moved.z);
  const bool turned = io.MouseDelta.x != 0 || io.MouseDelta.y != 0;
  if (turned && !ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
    model.holdCamera().lookAround(io.MouseDelta.x, io.MouseDelta.y, height_px);
  }
  return true;
}

bool isFlyKey(const KeyPress& press) {
  switch (press.key) {
    case GLFW_KEY_W:
    case GLFW_KEY_A:
    case GLFW_KEY_S:
    case GLFW_KEY_D:
    case GLFW_KEY_Q:
    case GLFW_KEY_E:
      return !press.control;
    default:
      return false;
  }
}

}  // namespace rocinante
