#include "viewer/ui/panels/hand_panel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>

#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "core/kinematics/joint_values.h"
#include "viewer/shown/joint_rows.h"
#include "viewer/ui/panels/icon_button.h"
#include "viewer/ui/panels/panel_parts.h"

namespace rocinante {
namespace {

constexpr float kToolGap = 3;

/// "arm/elbow, arm/wrist", or how many.
std::string drivenText(const JointsByDevice& joints) {
  std::vector<std::string> names;
  for (const auto& [device, values] : joints) {
    for (const auto& value : values) names.push_back(device + "/" + value.first);
  }
  return names.size() <= 3 ? fmt::format("{}", fmt::join(names, ", "))
                           : countText(names.size(), "joint");
}

/// The device's joints as `--joints` takes them.
std::string copiedJoints(const ViewModel& model, const PosedDevice& device) {
  JointVector joints = jointsOf(*device.model, model.state().findDevice(device.name));
  for (const std::string& name : positionalNames(*device.model)) {
    const auto set = model.hand.joints().find(device.name, name);
    const auto at = device.model->findJointValue(name);
    if (set && at) joints.values[joints.first_value[at->joint] + at->component] = *set;
  }
  const auto values = positionalValues(*device.model, joints);
  return "--joints " + shellWord(jointsText(model.cell(), device.name, values));
}

template <std::size_t kSize>
void fill(std::array<char, kSize>& text, const std::string& with) {
  std::snprintf(text.data(), text.size(), "%s", with.c_str());
}

void drawDrivePopup(HandControl& hand) {
  if (!ImGui::BeginPopup("drive")) return;
  ImGui::TextUnformatted("Send what is moved by hand");
  ImGui::SetNextItemWidth(px(300));
  ImGui::InputText("to", hand.drive_endpoint.data(), hand.drive_endpoint.size());
  explain("an endpoint: 127.0.0.1:19960, udp://GROUP:PORT?interface=lo");
  ImGui::SetNextItemWidth(px(300));
  ImGui::InputText("as", hand.drive_source.data(), hand.drive_source.size());
  explain("the name of the source");
  if (ImGui::Button("Drive")) {
    const Status begun = hand.drive(hand.drive_endpoint.data(), hand.drive_source.data());
    hand.trouble = begun ? std::string() : begun.error().text();
    if (begun) ImGui::CloseCurrentPopup();
  }
  if (!hand.trouble.empty())
    ImGui::TextColored(panelInk(PanelColor::fault), "%s", hand.trouble.c_str());
  ImGui::EndPopup();
}

void drawDrive(HandControl& hand) {
  if (hand.driving() != nullptr) {
    if (drawIconButton("stop", Icon::stop, "stop: nothing is sent any more (Esc)", true)) {
      hand.stopDriving();
    }
    return;
  }
  if (drawIconButton("drive beside", Icon::drive,
                     "drive: what is moved by hand is sent as a source, until Esc")) {
    if (hand.drive_endpoint[0] == 0) fill(hand.drive_endpoint, Endpoint::standard().text());
    if (hand.drive_source[0] == 0) fill(hand.drive_source, DriveSettings().source);
    hand.trouble.clear();
    ImGui::OpenPopup("drive");
  }
  drawDrivePopup(hand);
}

void drawUnits(Units& units) {
  if (drawTextButton("angles", std::string(nameOf(units.angle)),
                     "angles: degrees or radians (U: both units)")) {
    units.angle = units.angle == AngleUnit::degrees ? AngleUnit::radians : AngleUnit::degrees;
  }
  ImGui::SameLine(0, px(kToolGap));
  if (drawTextButton("lengths", std::string(nameOf(units.length)),
                     "lengths: millimetres or metres (U: both units)")) {
    units.length =
        units.length == LengthUnit::metres ? LengthUnit::millimetres : LengthUnit::metres;
  }
}

void drawHandTools(ViewModel& model, const PosedDevice& device) {
  HandControl& hand = model.hand;
  ImGui::BeginDisabled(!hand.joints().devices().contains(device.name));
  if (drawIconButton("reset", Icon::reset,
                     "reset: give all joints of this device back; Backspace: those of all devices"))
    hand.reset(device.name);
  ImGui::EndDisabled();
  ImGui::SameLine(0, px(kToolGap));
  if (drawIconButton("copy", Icon::copy,
                     "copy: all joint values, as --joints of rocinante model, render and view")) {
    ImGui::SetClipboardText(copiedJoints(model, device).c_str());
  }
  ImGui::SameLine();
  drawUnits(hand.units);
  ImGui::SameLine();
  drawDrive(hand);
}

}  // namespace

void drawMovers(const ViewModel& model, const DeviceState* received) {
  const std::string movers = received == nullptr ? std::string() : moversOf(*received);
  if (!movers.empty()) {
    drawCut("moved by " + movers, PanelColor::dim_text);
  } else if (model.isLive() || model.session() != nullptr) {
    ImGui::TextDisabled("no packet states it yet");
  }
}

void drawDeviceTools(ViewModel& model, const PosedDevice& device) {
  const bool has_joints = device.model->positionalCount() > 0;
  if (has_joints) drawHandTools(model, device);
  if (model.session() != nullptr) {
    bool& wanted = model.viewer.packet.wanted;
    if (has_joints) ImGui::SameLine(0, px(kToolGap));
    if (drawIconButton("packet", Icon::packet,
                       "packet: the one behind what is shown; a click on a joint's name: behind "
                       "its value",
                       wanted)) {
      wanted = !wanted;
    }
  }
  const HandControl& hand = model.hand;
  const bool shown_below = hand.driving() != nullptr || !ImGui::IsPopupOpen("drive");
  if (!has_joints || !shown_below || hand.trouble.empty()) return;
  ImGui::PushTextWrapPos(0);
  ImGui::TextColored(panelInk(PanelColor::fault), "%s", linesOf(hand.trouble).c_str());
  ImGui::PopTextWrapPos();
}

void drawDriveFrame(const ViewModel& model) {
  if (model.hand.driving() == nullptr) return;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float width = px(5);
  ImGui::GetForegroundDrawList()->AddRect(ImVec2(width / 2, width / 2),
                                          ImVec2(size.x - width / 2, size.y - width / 2),
                                          panelColor(PanelColor::driving), 0, 0, width);
}

HandBanner handBanner(const ViewModel& model) {
  const HandControl& hand = model.hand;
  HandBanner banner;
  if (hand.drawn() && model.session() != nullptr) {
    banner.what = fmt::format("what if: {} set by hand, not as the log has {}",
                              countText(hand.joints().count(), "joint"),
                              hand.joints().count() == 1 ? "it" : "them");
    banner.hint = "playing ends it; Backspace gives the joints back to the log";
  }
  if (const HandDrive* drive = hand.driving()) {
    const std::string who =
        fmt::format("driving {} as `{}`", drive->endpoint().text(), drive->source());
    banner.color = PanelColor::driving;
    banner.what = drive->joints().empty() ? who + ": what is moved by hand is sent"
                                          : fmt::format("{}: {}", who, drivenText(drive->joints()));
    banner.hint = model.isLive() ? "Esc, Backspace or N ends it; leaving now does, too"
                                 : "Esc or Backspace ends it; playing does, too";
    if (!drive->trouble().empty()) banner.hint = drive->trouble();
  }
  return banner;
}

}  // namespace rocinante
