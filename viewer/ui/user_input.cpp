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

void applyTransportKeys(Transport& transport, SteadyTime now) {
  const Nanoseconds step = ImGui::GetIO().KeyShift ? Nanoseconds(100ms) : Nanoseconds(1s);
  if (ImGui::IsKeyPressed(GLFW_KEY_SPACE, false)) transport.toggle(now);
  if (ImGui::IsKeyPressed(GLFW_KEY_LEFT)) transport.step(-step, now);
  if (ImGui::IsKeyPressed(GLFW_KEY_RIGHT)) transport.step(step, now);
  if (ImGui::IsKeyPressed(GLFW_KEY_HOME, false)) transport.seek(transport.start(), now);
  if (ImGui::IsKeyPressed(GLFW_KEY_END, false)) transport.seek(transport.end(), now);
}

}  // namespace

void applyUserInput(ViewModel& model, SteadyTime now, int height_px, bool& fit_requested,
                    Window& window) {
  applyMouse(model, height_px);
  if (ImGui::GetIO().WantTextInput) return;
  if (Transport* transport = model.transport()) applyTransportKeys(*transport, now);
  if (ImGui::IsKeyPressed(GLFW_KEY_F, false)) fit_requested = true;
  if (ImGui::IsKeyPressed(GLFW_KEY_TAB, false)) model.panels_shown = !model.panels_shown;
  if (ImGui::IsKeyPressed(GLFW_KEY_Q, false)) window.requestClose();
  const std::vector<std::string> cameras = model.cameraNames();
  for (std::size_t i = 0; i < cameras.size() && i < 9; ++i) {
    if (ImGui::IsKeyPressed(GLFW_KEY_1 + static_cast<int>(i), false)) model.useCamera(cameras[i]);
  }
}

}  // namespace rocinante
