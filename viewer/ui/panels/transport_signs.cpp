#include "viewer/ui/panels/transport_signs.h"

#include <imgui_internal.h>

#include <algorithm>

#include "viewer/ui/panels/panel_parts.h"

namespace rocinante {
namespace {

constexpr float kButtonWidth = 26;
constexpr float kSignSize = 13;

/// Its tip at the right end.
SignPart triangle(float left, float right, float half) {
  return {{{{left, 0.5F - half}, {right, 0.5F}, {left, 0.5F + half}}}, 3};
}

SignPart bar(float left, float right) {
  return {{{{left, 0.06F}, {right, 0.06F}, {right, 0.94F}, {left, 0.94F}}}, 4};
}

SignPart diamond(float middle, float half) {
  return {{{{middle, 0.5F - half},
            {middle + half, 0.5F},
            {middle, 0.5F + half},
            {middle - half, 0.5F}}},
          4};
}

std::vector<SignPart> mirrored(std::vector<SignPart> parts) {
  for (SignPart& part : parts) {
    for (SignPoint& corner : part.corners) corner.x = 1 - corner.x;
    // Still clockwise.
    std::reverse(part.corners.begin(),
                 part.corners.begin() + static_cast<std::ptrdiff_t>(part.count));
  }
  return parts;
}

}  // namespace

std::vector<SignPart> partsOf(TransportSign sign) {
  switch (sign) {
    case TransportSign::to_start:
      return mirrored(partsOf(TransportSign::to_end));
    case TransportSign::step_back:
      return mirrored(partsOf(TransportSign::step_on));
    case TransportSign::play:
      return {triangle(0.1F, 0.96F, 0.5F)};
    case TransportSign::play_back:
      return mirrored(partsOf(TransportSign::play));
    case TransportSign::pause:
      return {bar(0.14F, 0.4F), bar(0.6F, 0.86F)};
    case TransportSign::step_on:
      return {bar(0.08F, 0.26F), triangle(0.36F, 1, 0.44F)};
    case TransportSign::to_end:
      return {triangle(0, 0.42F, 0.44F), triangle(0.42F, 0.84F, 0.44F), bar(0.84F, 1)};
    case TransportSign::event_before:
      return mirrored(partsOf(TransportSign::event_after));
    case TransportSign::event_after:
      return {diamond(0.35F, 0.35F), triangle(0.72F, 1, 0.3F)};
  }
  return {};
}

bool drawSignButton(const char* id, TransportSign sign, const char* words, bool repeats) {
  const bool is_event = sign == TransportSign::event_before || sign == TransportSign::event_after;
  if (is_event) ImGui::PushStyleVar(ImGuiStyleVar_FrameRounding, ImGui::GetFrameHeight() / 2);
  ImGui::PushItemFlag(ImGuiItemFlags_ButtonRepeat, repeats);
  ImGui::PushID(id);
  const bool pressed = ImGui::Button("##sign", ImVec2(px(kButtonWidth), 0));
  ImGui::PopID();
  ImGui::PopItemFlag();
  if (is_event) ImGui::PopStyleVar();
  explain(words);
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float size = px(kSignSize);
  const float left = (low.x + high.x - size) / 2, top = (low.y + high.y - size) / 2;
  for (const SignPart& part : partsOf(sign)) {
    std::array<ImVec2, 4> corners;
    for (std::size_t i = 0; i < part.count; ++i) {
      corners[i] = ImVec2(left + part.corners[i].x * size, top + part.corners[i].y * size);
    }
    ImGui::GetWindowDrawList()->AddConvexPolyFilled(corners.data(), static_cast<int>(part.count),
                                                    ImGui::GetColorU32(ImGuiCol_Text));
  }
  return pressed;
}

}  // namespace rocinante
