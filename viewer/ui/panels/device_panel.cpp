#include "viewer/ui/panels/device_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/angle_text.h"
#include "viewer/ui/panels/joint_rows.h"
#include "viewer/ui/panels/panel_parts.h"

namespace rocinante {
namespace {

constexpr float kBarWidth = 84;
constexpr double kDegreesPerRadian = 57.29577951308232;

/// Draws the value as a mark on its range; amber near an end, red beyond.
void drawLimitBar(const JointRow& row) {
  const auto part = row.part();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetTextLineHeight();
  const float width = px(kBarWidth);
  ImGui::Dummy(ImVec2(width, height));
  if (!part) return;
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const float middle = corner.y + height / 2;
  list->AddRectFilled(ImVec2(corner.x, middle - px(3)), ImVec2(corner.x + width, middle + px(3)),
                      IM_COL32(70, 82, 94, 255), 3);
  const bool near = *part < 0.05 || *part > 0.95;
  const ImU32 color = row.outside() ? IM_COL32(255, 90, 70, 255)
                      : near        ? IM_COL32(255, 190, 70, 255)
                                    : IM_COL32(150, 220, 160, 255);
  const float at = corner.x + static_cast<float>(std::clamp(*part, 0.0, 1.0)) * width;
  list->AddRectFilled(ImVec2(at - px(2), corner.y + 1), ImVec2(at + px(2), corner.y + height - 1),
                      color, 2);
}

void drawRow(const JointRow& row) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  if (row.said) {
    ImGui::TextUnformatted(row.name.c_str());
  } else {
    ImGui::TextDisabled("%s", row.name.c_str());
  }
  std::string tip = row.said ? (row.mimics ? "follows another joint" : "")
                             : "nothing said: the model's own place";
  const auto shown = [&row](double number) {
    return row.in_radians ? angleText(number) : fmt::format("{:.4g}", number);
  };
  if (row.lower && row.upper) {
    tip += fmt::format("{}limits {} to {}", tip.empty() ? "" : "\n", shown(*row.lower),
                       shown(*row.upper));
  }
  if (row.in_radians) {
    tip +=
        fmt::format("{}{:.4f} in packets, which have radians", tip.empty() ? "" : "\n", row.value);
  }
  if (!tip.empty()) explain(tip.c_str());
  ImGui::TableNextColumn();
  const std::string value = row.in_radians ? fmt::format("{:.2f}°", row.value * kDegreesPerRadian)
                                           : fmt::format("{:.4f}", row.value);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x -
                       ImGui::CalcTextSize(value.c_str()).x);
  if (row.outside()) {
    ImGui::TextColored(ImVec4(1, 0.45F, 0.35F, 1), "%s", value.c_str());
  } else {
    ImGui::TextUnformatted(value.c_str());
  }
  ImGui::TableNextColumn();
  drawLimitBar(row);
}

void drawJoints(const ViewModel& model, const PosedDevice& device, const DeviceState* state,
                float bottom) {
  std::vector<JointRow> rows = jointRows(*device.model, state, model.selected.link);
  // A link without its own joint: show the device's joints.
  if (rows.empty()) rows = jointRows(*device.model, state, "");
  if (rows.empty()) {
    ImGui::TextDisabled("no joint");
    return;
  }
  // The rest of the panel, which ends above the time line.
  const float pitch = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
  const float left = bottom - ImGui::GetCursorScreenPos().y - ImGui::GetStyle().WindowPadding.y;
  const float height =
      std::min(std::max(left, 2 * pitch), static_cast<float>(rows.size()) * pitch + px(4));
  ImGui::BeginChild("joints", ImVec2(0, height));
  if (ImGui::BeginTable("values", 3)) {
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed, px(76));
    ImGui::TableSetupColumn("limits", ImGuiTableColumnFlags_WidthFixed, px(kBarWidth));
    for (const JointRow& row : rows) drawRow(row);
    ImGui::EndTable();
  }
  ImGui::EndChild();
}

void drawPlace(const ViewModel& model, const PosedDevice& device, const DeviceState* state) {
  const auto at = model.scene().find(device.name, model.selected.link);
  if (at) {
    // Print no sign for values that round to zero.
    const auto shown = [](double length_m) { return std::abs(length_m) < 5e-5 ? 0.0 : length_m; };
    ImGui::Text("at %.4f %.4f %.4f m", shown((*at)[3].x), shown((*at)[3].y), shown((*at)[3].z));
    explain("where its space begins, in the world");
  }
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

float drawDevicePanel(ViewModel& model, float top) {
  const ImGuiIO& io = ImGui::GetIO();
  const float bottom =
      io.DisplaySize.y - px(model.cursor() != nullptr ? kTimeBarHeight : kPanelMargin);
  if (model.selected.device.empty() || bottom - top < px(kLeastDeviceHeight)) return top;
  ImGui::SetNextWindowPos(ImVec2(io.DisplaySize.x - px(kPanelMargin), top), ImGuiCond_Always,
                          ImVec2(1, 0));
  ImGui::SetNextWindowSizeConstraints(ImVec2(px(kDevicePanelWidth), 0),
                                      ImVec2(px(kDevicePanelWidth), bottom - top));
  ImGui::Begin("device", nullptr, kPanelFlags | ImGuiWindowFlags_NoTitleBar);
  ImGui::TextUnformatted(model.selected.device.c_str());
  if (!model.selected.link.empty()) {
    ImGui::SameLine(0, 0);
    ImGui::Text("/%s", model.selected.link.c_str());
  }
  const auto said = model.state().devices().find(model.selected.device);
  const DeviceState* const state = said == model.state().devices().end() ? nullptr : &said->second;
  const PosedDevice* const device = model.scene().findDevice(model.selected.device);
  if (state == nullptr) ImGui::TextDisabled("nothing said yet");
  if (device != nullptr && device->model != nullptr) {
    drawPlace(model, *device, state);
    drawJoints(model, *device, state, bottom);
  } else if (state != nullptr) {
    drawBareValues(*state);
  }
  const float end = ImGui::GetWindowPos().y + ImGui::GetWindowSize().y;
  ImGui::End();
  return end;
}

}  // namespace rocinante
