#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "core/duration_text.h"
#include "viewer/ui/panel_parts.h"

namespace rocinante {
namespace {

constexpr float kTrackHeight = 22;
constexpr std::array kSpeeds{"0.1", "0.25", "0.5", "1", "2", "4", "10"};

void drawButtons(const ViewModel& model, Transport& transport, SteadyTime now) {
  if (ImGui::Button(transport.playing() ? "Pause" : "Play", ImVec2(64, 0))) transport.toggle(now);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Space");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(72);
  if (ImGui::BeginCombo("##speed", fmt::format("{}x", transport.speedText()).c_str())) {
    for (const char* speed : kSpeeds) {
      if (ImGui::Selectable(fmt::format("{}x", speed).c_str(), transport.speedText() == speed)) {
        transport.setSpeed(speed, now);
      }
    }
    ImGui::EndCombo();
  }
  ImGui::SameLine();
  const auto jump = [&](bool forward) {
    if (const Event* event = model.eventBeside(transport.position(now), forward)) {
      transport.seek(event->time, now);
    }
  };
  if (!model.events().empty()) {
    if (ImGui::Button("|<")) jump(false);
    explain("the event before (,)");
    ImGui::SameLine();
    if (ImGui::Button(">|")) jump(true);
    explain("the next event (.)");
    ImGui::SameLine();
  }
  bool looping = transport.looping();
  if (ImGui::Checkbox("loop", &looping)) transport.setLooping(looping);
}

/// The event whose tick lies within reach of the mouse.
const Event* eventNear(const ViewModel& model, float mouse_x, const auto& x_of) {
  const Event* nearest = nullptr;
  float best = 5;
  for (const Event& event : model.events()) {
    const float distance = std::abs(x_of(event.time) - mouse_x);
    if (distance < best) {
      best = distance;
      nearest = &event;
    }
  }
  return nearest;
}

void drawTrack(ViewModel& model, Transport& transport, SteadyTime now) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = std::max(40.0F, ImGui::GetContentRegionAvail().x);
  ImGui::InvisibleButton("track", ImVec2(width, kTrackHeight));
  const double span =
      std::max(1.0, static_cast<double>((transport.end() - transport.start()).count()));
  const auto x_of = [&](LogTime moment) {
    const double part = static_cast<double>((moment - transport.start()).count()) / span;
    return corner.x + static_cast<float>(std::clamp(part, 0.0, 1.0)) * width;
  };
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActive()) {
    const double part = std::clamp((io.MousePos.x - corner.x) / width, 0.0F, 1.0F);
    transport.seek(transport.start() + Nanoseconds(static_cast<std::int64_t>(part * span)), now);
  }

  ImDrawList* list = ImGui::GetWindowDrawList();
  const float middle = corner.y + kTrackHeight / 2;
  const float at = x_of(transport.position(now));
  list->AddRectFilled(ImVec2(corner.x, middle - 3), ImVec2(corner.x + width, middle + 3),
                      IM_COL32(70, 82, 94, 255), 3);
  list->AddRectFilled(ImVec2(corner.x, middle - 3), ImVec2(at, middle + 3),
                      IM_COL32(255, 168, 64, 255), 3);
  for (const Event& event : model.events()) {
    const float x = x_of(event.time);
    // A mark of a person has no source.
    const ImU32 color =
        event.source.empty() ? IM_COL32(150, 230, 140, 255) : IM_COL32(120, 200, 255, 255);
    list->AddRectFilled(ImVec2(x - 1, corner.y + 2), ImVec2(x + 1, corner.y + kTrackHeight - 2),
                        color);
  }
  list->AddCircleFilled(ImVec2(at, middle), 7, IM_COL32(255, 255, 255, 255), 20);
  if (ImGui::IsItemHovered()) {
    if (const Event* event = eventNear(model, io.MousePos.x, x_of)) {
      ImGui::SetTooltip("%s%s%s", event->source.c_str(), event->source.empty() ? "" : ": ",
                        event->text.c_str());
    }
  }
}

}  // namespace

void drawTimeBar(ViewModel& model, Transport& transport, SteadyTime now) {
  const ImGuiIO& io = ImGui::GetIO();
  ImGui::SetNextWindowPos(ImVec2(kPanelMargin, io.DisplaySize.y - kPanelMargin), ImGuiCond_Always,
                          ImVec2(0, 1));
  ImGui::SetNextWindowSize(ImVec2(io.DisplaySize.x - 2 * kPanelMargin, 0));
  ImGui::Begin("time", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
  drawButtons(model, transport, now);
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  const LogTime at = transport.position(now);
  // From the session's origin, to the millisecond.
  const auto shown = [&](LogTime moment) {
    return secondsText(std::chrono::floor<std::chrono::milliseconds>(moment - model.origin()), 3);
  };
  ImGui::Text("%s / %s s", shown(at).c_str(), shown(transport.end()).c_str());
  ImGui::SameLine();
  drawTrack(model, transport, now);
  ImGui::End();
}

}  // namespace rocinante
