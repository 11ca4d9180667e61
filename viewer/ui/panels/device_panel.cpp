#include "viewer/shown/joint_rows.h"
#include "viewer/ui/panels/hand_panel.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"
#include "viewer/ui/panels/placed_panel.h"
#include "viewer/ui/panels/plot_parts.h"

namespace rocinante {
namespace {

/// Plots x, y and z of a link's pose, or of one that packets state.
void drawPoseButton(ViewModel& model, const Selection& shown) {
  std::vector<SeriesKey> parts;
  for (const char* part : {"x", "y", "z"}) {
    if (const auto key = poseKeyOf(model, shown, part)) parts.push_back(*key);
  }
  if (parts.empty()) return;
  drawPlotButton(model, "plot pose", parts);
  ImGui::SameLine(0, px(5));
}

void drawCarrier(const DeviceState* state) {
  if (state != nullptr && state->pose && !state->pose->value.carrier.first.empty()) {
    ImGui::Text("carried by %s%s%s", state->pose->value.carrier.first.c_str(),
                state->pose->value.carrier.second.empty() ? "" : "/",
                state->pose->value.carrier.second.c_str());
  }
}

/// Values of a device without a known model, as received.
void drawBareValues(const DeviceState& state) {
  if (state.joints) {
    for (std::size_t i = 0; i < state.joints->value.size(); ++i) {
      ImGui::Text("[%zu] %9.4f", i, state.joints->value[i]);
    }
  }
  for (const auto& [name, value] : state.named_joints) {
    ImGui::Text("%-14s %9.4f", name.c_str(), value.value);
  }
}

}  // namespace

void drawDevicePanel(ViewModel& model, const PanelRectangle& room, SteadyTime now) {
  const Selection shown = model.inspected();
  PlacedPanel placed(model.viewer.panels.places, "device", {DockEdge::right, room},
                     px(kDevicePanelWidth));
  if (placed.floating() && shown.device.empty()) return;
  if (!placed.begin()) return;
  if (shown.device.empty()) {
    ImGui::TextDisabled("nothing is selected:");
    ImGui::TextDisabled("click a device in the picture");
    placed.end();
    return;
  }
  ImGui::TextUnformatted(shown.device.c_str());
  if (!shown.link.empty()) {
    ImGui::SameLine(0, 0);
    ImGui::Text("/%s", shown.link.c_str());
  }
  const DeviceState* const state = model.received().findDevice(shown.device);
  const PosedDevice* const device = model.scene().findDevice(shown.device);
  if (!placed.collapsed()) drawMovers(model, state);
  if (placed.collapsed()) {
    ImGui::SameLine();
    ImGui::TextDisabled("...");
  } else if (device != nullptr && device->model != nullptr) {
    drawPoseButton(model, shown);
    drawPose(model, shown);
    drawCarrier(state);
    drawNearest(model, shown);
    drawHandButtons(model, *device);
    drawPacketBehind(model, *device, shown, placed.bottom());
    if (state != nullptr) drawSignals(model, shown.device, shown.link, state->signals);
    drawJointSliders(model, *device, shown.link, placed.bottom(), now);
  } else if (state != nullptr) {
    drawSignals(model, shown.device, shown.link, state->signals);
    drawBareValues(*state);
  }
  placed.end();
}

}  // namespace rocinante
