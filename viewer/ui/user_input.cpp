#include "viewer/ui/user_input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include "viewer/ui/window.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

void applyMouse(ViewModel& model, int height_px) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantCaptureMouse) return;
  const ImVec2 moved = io.MouseDelta;
  const bool panning = ImGui::IsMouseDown(ImGuiMouseButton_Middle) ||
                       ImGui::IsMouseDown(ImGuiMouseButton_Right) ||
                       (ImGui::IsMouseDown(ImGuiMouseButton_Left) && io.KeyShift);
  if (moved.x != 0 || moved.y != 0) {
    if (panning) {
      model.holdCamera().pan(moved.x, moved.y, height_px);
    } else if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
      model.holdCamera().orbit(moved.x, moved.y, height_px);
    }
  }
  if (io.MouseWheel != 0) model.holdCamera().zoom(io.MouseWheel);
}

void applyTransportKey(Transport& transport, const KeyPress& press, SteadyTime now) {
  const Nanoseconds step = press.shift ? Nanoseconds(100ms) : Nanoseconds(1s);
  switch (press.key) {
    case GLFW_KEY_LEFT:
      transport.step(-step, now);
      break;
    case GLFW_KEY_RIGHT:
      transport.step(step, now);
      break;
    case GLFW_KEY_SPACE:
      if (!press.repeated) transport.toggle(now);
      break;
    case GLFW_KEY_HOME:
      transport.seek(transport.start(), now);
      break;
    case GLFW_KEY_END:
      transport.seek(transport.end(), now);
      break;
    default:
      break;
  }
}

}  // namespace

void applyUserInput(ViewModel& model, SteadyTime now, int height_px, bool& fit_requested,
                    Window& window) {
  applyMouse(model, height_px);
  const std::vector<KeyPress> presses = window.takeKeyPresses();
  if (ImGui::GetIO().WantTextInput) return;
  for (const KeyPress& press : presses) {
    if (Transport* transport = model.transport()) applyTransportKey(*transport, press, now);
    if (press.repeated) continue;
    if (press.key == GLFW_KEY_F) fit_requested = true;
    if (press.key == GLFW_KEY_TAB) model.panels_shown = !model.panels_shown;
    if (press.key == GLFW_KEY_Q) window.requestClose();
    const std::vector<std::string> cameras = model.cameraNames();
    const int number = press.key - GLFW_KEY_1;
    if (number >= 0 && number < 9 && static_cast<std::size_t>(number) < cameras.size()) {
      model.useCamera(cameras[static_cast<std::size_t>(number)]);
    }
  }
}

}  // namespace rocinante
