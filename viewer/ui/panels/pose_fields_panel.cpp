#include "viewer/ui/panels/pose_fields_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "viewer/ui/model/pose_fields.h"
#include "viewer/ui/panels/panel_parts.h"

namespace rocinante {
namespace {

/// A number in a field is rounded until it is typed over.
int openExactly(ImGuiInputTextCallbackData* data) {
  const auto* const exact = static_cast<const std::string*>(data->UserData);
  if (exact == nullptr) return 0;
  data->DeleteChars(0, data->BufTextLen);
  data->InsertChars(0, exact->c_str());
  data->SelectAll();
  return 0;
}

void fillText(PoseTyping& typing, const std::string& with) {
  typing.text.fill(0);
  with.copy(typing.text.data(), typing.text.size() - 1);
}

std::string fieldTip(const PoseTyping& typing, const Units& units) {
  const bool is_angle = isAngleField(typing.field);
  std::string tip =
      fmt::format("{} {}", typing.opened, is_angle ? nameOf(units.angle) : nameOf(units.length));
  if (is_angle) tip += "\nroll, pitch, yaw about fixed axes, as URDF has them";
  return tip + "\nEnter, or leaving the field, sets it; Esc puts it back";
}

std::array<float, 2> mousePlace() {
  const ImVec2 at = ImGui::GetIO().MousePos;
  return {at.x, at.y};
}

/// `fixed`: why it cannot be changed; empty: it can.
void drawPoseField(ViewModel& model, const Pose& pose, std::size_t field,
                   const std::string& fixed) {
  PoseFields& fields = model.viewer.panels.pose_fields;
  const Units& units = model.hand.units;
  const auto& open = fields.typing;
  const bool is_open = open && open->device == model.selected.device && open->field == field;
  PoseTyping shown;
  if (is_open) {
    shown = *open;
  } else {
    shown.device = model.selected.device;
    shown.field = field;
    shown.opened = openedPoseText(pose, field, units);
    fillText(shown, poseFieldText(pose, field, units));
  }
  ImGui::SetNextItemWidth(-1);
  ImGui::BeginDisabled(!fixed.empty());
  ImGui::InputText("##number", shown.text.data(), shown.text.size(),
                   ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_CallbackAlways,
                   openExactly, is_open ? nullptr : &shown.opened);
  ImGui::EndDisabled();
  // It would lie over the fields below, of which the next may be wanted, and over what is wrong.
  const bool has_tip =
      !fixed.empty() || (!fields.typing && fields.trouble.empty() && !fields.rests_at);
  if (has_tip && !ImGui::IsItemActive() &&
      ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
    ImGui::SetTooltip("%s", fixed.empty() ? fieldTip(shown, units).c_str() : fixed.c_str());
  }
  const bool has_keyboard = ImGui::IsItemActive();
  if (has_keyboard && !is_open) {
    takeTypedPose(model);  // of the field that Tab left
    fillText(shown, shown.opened);
  }
  if (has_keyboard) shown.frame = ImGui::GetFrameCount();
  if (!has_keyboard && !is_open) return;
  fields.typing = std::move(shown);
  fields.rests_at = mousePlace();
}

/// What the fields are drawn of.
struct DrawnFields {
  const Pose& pose;
  const std::string& fixed;  ///< as drawPoseField()
  float names = 0;           ///< the width of their names
};

/// Fields below each other, in the order in which Tab goes.
void drawFieldColumn(ViewModel& model, const DrawnFields& drawn, std::size_t first, std::size_t end,
                     float width) {
  const std::string id = fmt::format("pose by hand {}", first);
  if (!ImGui::BeginTable(id.c_str(), 2, 0, ImVec2(width, 0))) return;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, drawn.names);
  ImGui::TableSetupColumn("number", ImGuiTableColumnFlags_WidthStretch);
  for (std::size_t field = first; field < end; ++field) {
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", kPoseFields[field].data());
    ImGui::TableNextColumn();
    ImGui::PushID(static_cast<int>(field));
    drawPoseField(model, drawn.pose, field, drawn.fixed);
    ImGui::PopID();
  }
  ImGui::EndTable();
}

}  // namespace

void drawPoseFields(ViewModel& model) {
  if (!hasPoseFields(model)) return;
  PoseFields& fields = model.viewer.panels.pose_fields;
  if (fields.rests_at != mousePlace()) fields.rests_at.reset();
  const PosedDevice* const device = model.scene().findDevice(model.selected.device);
  if (device == nullptr) return;
  const auto movable = model.movablePose(device->name);
  const std::string fixed = movable ? std::string() : movable.error().what;
  const Pose pose = movable ? *movable : device->pose;
  std::string space = device->carrier.empty() ? "the world" : device->carrier;
  if (!device->carrier_link.empty()) space += "/" + device->carrier_link;
  drawCut(fmt::format("{} in {}, {} and {}", device->name, space, nameOf(model.hand.units.length),
                      nameOf(model.hand.units.angle)),
          PanelColor::dim_text);
  const auto widest = [](std::size_t first, std::size_t end) {
    float width = 0;
    for (std::size_t i = first; i < end; ++i) width = std::max(width, drawnWidth(kPoseFields[i]));
    return width;
  };
  const float places = widest(0, 3), angles = widest(3, 6);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(3), 0));
  const float gap = 2 * ImGui::GetStyle().CellPadding.x;  // as between columns of a table
  const float room = ImGui::GetContentRegionAvail().x;
  const float both = places + angles + 2 * (drawnWidth("-1234.5") + px(6)) + 3 * gap;
  if (poseFieldColumns(room, both) == 2) {
    const float number = std::floor((room - places - angles - 3 * gap) / 2);
    drawFieldColumn(model, {pose, fixed, places}, 0, 3, places + gap + number);
    ImGui::SameLine(0, gap);
    drawFieldColumn(model, {pose, fixed, angles}, 3, 6, 0);
  } else {
    drawFieldColumn(model, {pose, fixed, angles}, 0, 6, 0);
  }
  ImGui::PopStyleVar();
  const std::string& trouble = fields.trouble;
  if (trouble.empty()) return;
  ImGui::PushTextWrapPos(0);
  ImGui::TextColored(panelInk(PanelColor::fault), "%s", linesOf(trouble).c_str());
  ImGui::PopTextWrapPos();
}

void settlePoseFields(ViewModel& model) {
  PoseFields& fields = model.viewer.panels.pose_fields;
  if (!fields.typing) return;
  const int since = ImGui::GetFrameCount() - fields.typing->frame;
  if (since == 0) return;
  // Hidden panels left it some frames ago.
  if (since > 1 || keyPressed(ImGuiKey_Escape)) {
    fields.typing.reset();
    fields.trouble.clear();
  } else {
    takeTypedPose(model);
  }
}

}  // namespace rocinante
