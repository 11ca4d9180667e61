#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "viewer/shown/joint_rows.h"
#include "viewer/shown/value_text.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"
#include "viewer/ui/panels/plot_parts.h"

namespace rocinante {
namespace {

constexpr float kLeastSlider = 44;
constexpr float kValueWidth = 66;
constexpr float kResetWidth = 14;

/// A row with what the user set.
struct HandRow {
  JointRow row;  ///< its value is the one that the slider says
  bool by_hand = false;
  double received = 0;  ///< by packets, else the model's own
};

std::vector<HandRow> handRows(const ViewModel& model, const PosedDevice& device,
                              const std::string& link) {
  const DeviceState* const received = model.received().findDevice(device.name);
  const DeviceState* const shown = model.state().findDevice(device.name);
  std::vector<JointRow> before = jointRows(*device.model, received, link);
  std::vector<JointRow> now = jointRows(*device.model, shown, link);
  std::vector<HandRow> rows;
  for (std::size_t i = 0; i < now.size(); ++i) {
    HandRow one{now[i], false, before[i].value};
    one.row.owner = before[i].owner;
    one.row.is_stated = before[i].is_stated;
    if (const auto set = model.hand.joints().find(device.name, one.row.name)) {
      one.by_hand = true;
      one.row.value = *set;
    }
    rows.push_back(std::move(one));
  }
  return rows;
}

/// Empty when the text is not a value of that kind.
std::optional<double> parsedValue(const JointRow& row, std::string_view text, const Units& units) {
  switch (row.kind) {
    case ValueKind::angle:
      return parseAngle(text, units.angle);
    case ValueKind::length:
      return parseLength(text, units.length);
    case ValueKind::turn:
      break;
  }
  return parseLength(text, LengthUnit::metres);
}

std::string rowTip(const HandRow& one, const Units& units, bool settable) {
  const JointRow& row = one.row;
  std::string tip = row.name;
  if (row.mimics) {
    tip += "\nfollows another joint";
  } else if (!row.owner.empty()) {
    tip += "\nmoved by " + row.owner;
  } else if (!row.is_stated) {
    tip += "\nnot stated: at the model's default";
  }
  if (row.lower && row.upper) {
    tip += fmt::format("\nlimits {} to {}", jointValueText(row.kind, *row.lower, units),
                       jointValueText(row.kind, *row.upper, units));
  }
  if (one.by_hand) tip += "\nby hand; otherwise " + jointValueText(row.kind, one.received, units);
  tip += fmt::format("\n{:.4f} in packets{}", row.value,
                     row.kind == ValueKind::angle    ? ", which have radians"
                     : row.kind == ValueKind::length ? ", which have metres"
                                                     : "");
  if (settable) tip += "\ndrag; Shift: finely; double click: type; right click: reset";
  return tip;
}

void drawJointTrack(const HandRow& one, const SliderRange& range, const ImVec2& corner, float width,
                    float height, bool settable, bool hot) {
  const JointRow& row = one.row;
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const float middle = corner.y + height / 2;
  const float half = px(2.5F);
  const float inset = px(4);
  const auto x_of = [&](double value) {
    return corner.x + inset + static_cast<float>(range.partOf(row, value)) * (width - 2 * inset);
  };
  list->AddRectFilled(ImVec2(corner.x, middle - half), ImVec2(corner.x + width, middle + half),
                      panelColor(hot ? PanelColor::slider_track_hovered : PanelColor::slider_track),
                      half);
  if (one.by_hand && one.received != row.value) {
    const float before = x_of(one.received);
    list->AddRectFilled(ImVec2(before - px(1), corner.y + px(2)),
                        ImVec2(before + px(1), corner.y + height - px(2)),
                        panelColor(PanelColor::received_mark));
  }
  const auto part = row.part();
  const bool near = part && (*part < 0.05 || *part > 0.95);
  const ImU32 color = panelColor(row.outside() ? PanelColor::out_of_limits
                                 : one.by_hand ? PanelColor::by_hand
                                 : near        ? PanelColor::near_limit
                                               : PanelColor::within_limits);
  const float at = x_of(row.value);
  const float thumb = settable ? px(4) : px(2);
  list->AddRectFilled(ImVec2(at - thumb, corner.y + px(1)),
                      ImVec2(at + thumb, corner.y + height - px(1)), color, px(2));
}

void beginEdit(ViewModel& model, const std::string& device, const HandRow& one) {
  ValueEdit edit;
  edit.device = device;
  edit.value_name = one.row.name;
  const Units& units = model.hand.units;
  const std::string text =
      one.row.kind == ValueKind::angle    ? angleNumber(one.row.value, units.angle)
      : one.row.kind == ValueKind::length ? lengthNumber(one.row.value, units.length)
                                          : fmt::format("{:.4f}", one.row.value);
  std::snprintf(edit.text.data(), edit.text.size(), "%s", text.c_str());
  model.hand.edit = edit;
}

void complainOf(ViewModel& model, const Status& set) {
  model.hand.trouble = set ? std::string() : set.error().text();
}

void drawSlider(ViewModel& model, const PosedDevice& device, const HandRow& one, bool settable,
                SteadyTime now) {
  const SliderRange range = sliderRange(one.row);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetTextLineHeight();
  const float width = ImGui::GetContentRegionAvail().x;
  if (!settable) {
    ImGui::Dummy(ImVec2(width, height));
    drawJointTrack(one, range, corner, width, height, false, false);
    explain(rowTip(one, model.hand.units, false).c_str());
    return;
  }
  ImGui::InvisibleButton("slider", ImVec2(width, height));
  const bool hovered = ImGui::IsItemHovered();
  HandControl& hand = model.hand;
  const auto set = [&](double value) {
    complainOf(model, model.setByHand(device.name, one.row.name, value, now));
  };
  const float inset = px(4);
  const float reach = width - 2 * inset;
  const auto mouse = static_cast<double>((ImGui::GetIO().MousePos.x - corner.x - inset) / reach);
  if (ImGui::IsItemActivated()) {
    hand.before_press = one.by_hand ? std::optional(one.row.value) : std::nullopt;
    // A press beside the thumb brings it there; on the thumb it only takes it. Nothing that is
    // driven jumps to where the mouse was pressed.
    const double here = range.partOf(one.row, one.row.value);
    const bool on_thumb = std::abs(here - mouse) * static_cast<double>(reach) <= px(7);
    const bool takes = on_thumb || ImGui::GetIO().KeyShift || hand.driving() != nullptr;
    hand.grabbed_at = takes ? mouse - here : 0;
    if (!takes) set(range.valueAt(std::clamp(mouse, 0.0, 1.0)));
  } else if (ImGui::IsItemActive() && ImGui::GetIO().MouseDelta.x != 0) {
    double part = mouse - hand.grabbed_at;
    if (ImGui::GetIO().KeyShift) {
      const double moved = static_cast<double>(ImGui::GetIO().MouseDelta.x / reach);
      part = range.partOf(one.row, one.row.value) + moved * 0.1;
      hand.grabbed_at = mouse - part;
    }
    set(range.valueAt(std::clamp(part, 0.0, 1.0)));
  }
  if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    // The first of the two clicks moved it.
    HandRow before = one;
    before.row.value = hand.before_press.value_or(one.received);
    if (hand.before_press) {
      set(*hand.before_press);
    } else {
      hand.reset(device.name, one.row.name);
    }
    beginEdit(model, device.name, before);
  }
  if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right))
    hand.reset(device.name, one.row.name);
  drawJointTrack(one, range, corner, width, height, true, hovered || ImGui::IsItemActive());
  if (!ImGui::IsItemActive()) explain(rowTip(one, hand.units, true).c_str());
}

/// The value as a field; what is not a value stays there, in red.
void drawEdit(ViewModel& model, const JointRow& row, SteadyTime now) {
  ValueEdit& edit = *model.hand.edit;
  if (!edit.begun) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  if (edit.invalid) ImGui::PushStyleColor(ImGuiCol_Text, panelInk(PanelColor::beyond_limit));
  const bool entered =
      ImGui::InputText("##value", edit.text.data(), edit.text.size(),
                       ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  if (edit.invalid) ImGui::PopStyleColor();
  const bool left = edit.begun && ImGui::IsItemDeactivated();
  edit.begun = edit.begun || ImGui::IsItemActive();
  if (!entered) {
    if (left) model.hand.edit.reset();
    return;
  }
  const auto value = parsedValue(row, edit.text.data(), model.hand.units);
  if (!value) {
    edit.invalid = true;
    edit.begun = false;
    return;
  }
  const ValueEdit done = edit;
  model.hand.edit.reset();
  complainOf(model, model.setByHand(done.device, done.value_name, *value, now));
}

void drawValue(ViewModel& model, const PosedDevice& device, const HandRow& one, bool settable,
               SteadyTime now) {
  const JointRow& row = one.row;
  const auto& edit = model.hand.edit;
  if (edit && edit->device == device.name && edit->value_name == row.name) {
    return drawEdit(model, row, now);
  }
  const std::string text = jointValueText(row.kind, row.value, model.hand.units);
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(room, 0.0F));
  const PanelColor color = row.outside() ? PanelColor::beyond_limit
                           : one.by_hand ? PanelColor::by_hand
                                         : PanelColor::text;
  ImGui::TextColored(panelInk(color), "%s", text.c_str());
  if (settable && ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    beginEdit(model, device.name, one);
  }
  explain(rowTip(one, model.hand.units, settable).c_str());
}

/// `name`: as there is room for it.
void drawRow(ViewModel& model, const PosedDevice& device, const HandRow& one,
             const std::string& name, SteadyTime now) {
  const JointRow& row = one.row;
  const bool settable = !row.mimics && model.hand.use() != HandUse::none;
  ImGui::PushID(row.name.c_str());
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  if (model.session() != nullptr) {
    drawPlotButton(model, {SeriesKey::Kind::joint, device.name, row.name});
    ImGui::SameLine(0, px(kPlotButtonGap));
  }
  const ImGuiCol ink = row.is_stated || one.by_hand ? ImGuiCol_Text : ImGuiCol_TextDisabled;
  drawDraggable(model, "name", name, ink, {{SeriesKey::Kind::joint, device.name, row.name}});
  if (ImGui::IsItemClicked() && model.viewer.packet.wanted)
    model.viewer.packet.value_name = row.name;
  explain(rowTip(one, model.hand.units, settable).c_str());
  ImGui::TableNextColumn();
  drawSlider(model, device, one, settable, now);
  ImGui::TableNextColumn();
  drawValue(model, device, one, settable, now);
  ImGui::TableNextColumn();
  if (one.by_hand) {
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
    if (ImGui::SmallButton("x")) model.hand.reset(device.name, row.name);
    ImGui::PopStyleColor();
    explain("give this joint back");
  }
  ImGui::PopID();
}

/// As wide as the widest name, if that leaves sliders their least.
float nameColumn(const std::vector<std::string>& names, float before, float panel) {
  float widest = 0;
  for (const std::string& name : names) widest = std::max(widest, drawnWidth(name));
  const float gaps = 6 * ImGui::GetStyle().CellPadding.x;
  const float room = panel - px(kLeastSlider + kValueWidth + kResetWidth) - gaps;
  return std::clamp(before + widest + px(1), before, std::max(room, before));
}

}  // namespace

void drawJointSliders(ViewModel& model, const PosedDevice& device, const std::string& link,
                      float bottom, SteadyTime now) {
  std::vector<HandRow> rows = handRows(model, device, link);
  // A link without its own joint: the device's joints.
  if (rows.empty()) rows = handRows(model, device, "");
  if (rows.empty()) {
    ImGui::TextDisabled("no joint");
    return;
  }
  // The rest of the panel, which ends above the time line.
  const float pitch = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
  const float left = bottom - ImGui::GetCursorScreenPos().y - ImGui::GetStyle().WindowPadding.y;
  const float wanted = static_cast<float>(rows.size()) * pitch + px(8);
  ImGui::BeginChild("joints", ImVec2(0, std::min(std::max(left, 2 * pitch), wanted)));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(3), 0));
  const float panel = ImGui::GetContentRegionAvail().x;
  if (ImGui::BeginTable("values", 4)) {
    // Of all joints of the device, also where a link's alone are listed: called the same.
    std::vector<std::string> whole;
    for (const JointRow& row : jointRows(*device.model, nullptr, "")) whole.push_back(row.name);
    const float before = model.session() != nullptr ? px(kPlotButtonSide + kPlotButtonGap) : 0.0F;
    const float column = nameColumn(whole, before, panel);
    const std::vector<std::string>& shown =
        model.viewer.panels.short_names.of("joints", whole, column - before, drawnWidth);
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, column);
    ImGui::TableSetupColumn("slider", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed, px(kValueWidth));
    ImGui::TableSetupColumn("reset", ImGuiTableColumnFlags_WidthFixed, px(kResetWidth));
    std::size_t place = 0;  // both are in the model's order
    for (const HandRow& row : rows) {
      while (place + 1 < whole.size() && whole[place] != row.row.name) ++place;
      drawRow(model, device, row, shown[place], now);
    }
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
}

}  // namespace rocinante
