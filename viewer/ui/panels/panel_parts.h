#pragma once

#include <imgui.h>

#include <string_view>

#include "viewer/ui/panels/panel_layout.h"
#include "viewer/ui/window/interface_context.h"

/// Helpers of the panels. Only panels include this.
namespace rocinante {

/// Converts an interface length (for scale 1) to pixels of this screen.
inline float px(float length) { return length * ImGui::GetFontSize() / kFontPixels; }

constexpr ImGuiWindowFlags kPanelFlags =
    ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;

/// Whether the text contains the word, ignoring case.
bool containsWord(std::string_view text, std::string_view word);

/// Adds a tool tip to the last drawn item.
inline void explain(const char* text) {
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
}

}  // namespace rocinante
