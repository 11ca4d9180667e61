#include <fmt/format.h>

#include <algorithm>

#include "viewer/shown/joint_rows.h"
#include "viewer/ui/panels/hand_panel.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"
#include "viewer/ui/panels/placed_panel.h"
#include "viewer/ui/panels/plot_parts.h"
#include "viewer/ui/panels/pose_fields_panel.h"

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
    const auto& carrier = state->pose->value.carrier;
    drawCut("carried by " + carrier.first + (carrier.second.empty() ? "" : "/" + carrier.second));
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
    const std::string number = fmt::format("{:.4f}", value.value);
    const float room = ImGui::GetContentRegionAvail().x - drawnWidth(number) - px(12);
    drawCut(name, PanelColor::text, std::max(room, px(40)));
    ImGui::SameLine();
    const float right = ImGui::GetContentRegionAvail().x - drawnWidth(number);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(right, 0.0F));
    ImGui::TextUnformatted(number.c_str());
  }
}

void drawInspected(ViewModel& model, const PanelRectangle& room, SteadyTime now) {
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
  const float beside = placed.collapsed() ? drawnWidth("...") + ImGui::GetStyle().ItemSpacing.x : 0;
  const float name_room = ImGui::GetContentRegionAvail().x - beside;
  const std::string name = cutPath(shown.device, shown.link, name_room, drawnWidth);
  ImGui::TextUnformatted(name.c_str());
  explainCut(name, shown.link.empty() ? shown.device : shown.device + "/" + shown.link);
  const DeviceState* const state = model.received().findDevice(shown.device);
  const PosedDevice* const device = model.scene().findDevice(shown.device);
  if (!placed.collapsed()) drawMovers(model, state);
  if (placed.collapsed()) {
    ImGui::SameLine();
    ImGui::TextDisabled("...");
  } else if (device != nullptr && device->model != nullptr) {
    drawPoseFields(model);
    drawPoseButton(model, shown);
    drawPose(model, shown);
    drawCarrier(state);
    drawNearest(model, shown);
    drawDeviceTools(model, *device);
    drawPacketBehind(model, *device, shown, placed.bottom());
    if (state != nullptr) drawSignals(model, shown.device, shown.link, state->signals);
    drawJointSliders(model, *device, shown.link, placed.bottom(), now);
  } else if (state != nullptr) {
    drawSignals(model, shown.device, shown.link, state->signals);
    drawBareValues(*state);
  }
  placed.end();
}

}  // namespace

void drawDevicePanel(ViewModel& model, const PanelRectangle& room, SteadyTime now) {
  drawInspected(model, room, now);
  settlePoseFields(model);
}

}  // namespace rocinante
