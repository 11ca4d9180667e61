/// Helpers of the panels. Only panels include this.
#pragma once

#include <imgui.h>

#include <span>
#include <string>
#include <string_view>

#include "viewer/ui/model/line_start.h"
#include "viewer/ui/panels/panel_layout.h"
#include "viewer/ui/window/interface_context.h"

namespace rocinante {

/// Draws a line to type in, as wide as there is room. `takes_keyboard`: in a moment; what is typed
/// until then is in `start`, and is taken by the line. True when Enter was pressed.
bool drawTypedLine(const char* id, const char* hint, std::span<char> text, bool takes_keyboard,
                   LineStart& start);

/// Converts an interface length (for scale 1) to pixels of this screen.
inline float px(float length) { return length * ImGui::GetFontSize() / kFontPixels; }

constexpr ImGuiWindowFlags kPanelFlags =
    ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;

/// Whether the text contains the word, ignoring case.
bool containsWord(std::string_view text, std::string_view word);

/// As much of the name as there is room for: its end, since names of one machine begin alike.
std::string endOfName(const std::string& name, float room);
/// As much of the text as there is room for: its beginning.
std::string shortened(const std::string& text, float room);

/// How far a list must be scrolled to show a row whole, from `scroll`: not at all when it is seen,
/// else so that it stands in the middle. `top` and `height` of the row from the list's beginning,
/// `room`: the list's height. Pixels. Pure.
float scrollToShow(float scroll, float top, float height, float room);

/// Whether a list that grows shows its newest row: not when the user has scrolled up from `most`,
/// the end of its way before it grew. Pure.
inline bool followsNewest(float scroll, float most) { return scroll >= most - 1; }

/// Whether a key of Dear ImGui went down or repeats.
inline bool keyPressed(ImGuiKey key) {
#if IMGUI_VERSION_NUM >= 18700
  return ImGui::IsKeyPressed(key);
#else
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
#endif
}

/// A color of text for dark panels, dark enough for the theme that is used.
inline ImVec4 ink(const ImVec4& color) {
  const ImVec4& below = ImGui::GetStyleColorVec4(ImGuiCol_WindowBg);
  if (below.x + below.y + below.z < 1.5F) return color;
  return ImVec4(color.x * 0.62F, color.y * 0.55F, color.z * 0.55F, color.w);
}

/// Adds a tool tip to the last drawn item.
inline void explain(const char* text) {
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
}

}  // namespace rocinante
