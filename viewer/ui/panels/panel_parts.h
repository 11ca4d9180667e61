#pragma once

#include <imgui.h>

#include <string_view>

#include "viewer/ui/panels/panel_layout.h"
#include "viewer/ui/window/interface_context.h"

/// What panels are made of. Only panels include this.
namespace rocinante {

/// A length of the interface in pixels of this screen: all of ours are given for scale 1.
inline float px(float length) { return length * ImGui::GetFontSize() / kFontPixels; }

constexpr ImGuiWindowFlags kPanelFlags =
    ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;

/// Whether the word is somewhere in the text, whatever the case of its letters.
bool containsWord(std::string_view text, std::string_view word);

/// A tool tip for what was drawn last.
inline void explain(const char* text) {
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
}

}  // namespace rocinante
